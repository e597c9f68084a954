import { classHighlighter, highlightCode } from "@lezer/highlight";
import { parser as htmlParser } from "@lezer/html";
import { parser as scriptParser } from "@lezer/javascript";

const PARSERS = { html: htmlParser, ts: scriptParser.configure({ dialect: "ts" }) } as const;

/** Code as HTML, its parts in spans with the classes of `classHighlighter`. The text in it is the code, unchanged. */
export function highlight(code: string, language: keyof typeof PARSERS): string {
  let html = "";
  highlightCode(
    code,
    PARSERS[language].parse(code),
    classHighlighter,
    (text, classes) => {
      html += classes === "" ? escapeHtml(text) : `<span class="${classes}">${escapeHtml(text)}</span>`;
    },
    () => {
      html += "\n";
    },
  );
  return html;
}

export function escapeHtml(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}
