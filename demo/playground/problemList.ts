import type { Problem } from "./check";

// More than this nobody reads, and the rest are often the same one.
const MAX_SHOWN = 20;

/** Shows what is wrong as a list of buttons that lead to the place. */
export function showProblems(
  list: HTMLElement,
  problems: readonly Problem[],
  lineOf: (position: number) => number,
  onChoose: (problem: Problem) => void,
): void {
  const items = problems.slice(0, MAX_SHOWN).map((problem) => {
    const item = document.createElement("li");
    const button = document.createElement("button");
    button.type = "button";
    const line = document.createElement("span");
    line.textContent = `line ${lineOf(problem.from)}`;
    const path = document.createElement("code");
    path.textContent = problem.path;
    button.append(line, " ", path, path.textContent === "" ? "" : ": ", problem.message);
    button.addEventListener("click", () => onChoose(problem));
    item.append(button);
    return item;
  });
  if (problems.length > MAX_SHOWN) {
    const rest = document.createElement("li");
    rest.textContent = `… and ${problems.length - MAX_SHOWN} more`;
    items.push(rest);
  }
  list.replaceChildren(...items);
}
