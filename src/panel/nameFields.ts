/**
 * Gives every field below an element the name that its row shows: Tweakpane's labels are for the eye only.
 *
 * @param group - comes before the names, where several groups have rows of the same name.
 */
export function nameFields(element: HTMLElement, group = ""): void {
  for (const row of element.querySelectorAll(".tp-lblv")) {
    const text = row.querySelector(".tp-lblv_l")?.textContent;
    if (!text) continue;
    const label = `${group} ${text}`.trim();
    const fields = [...row.querySelectorAll("input, select, textarea")];
    const axes = row.querySelector(".tp-pndtxtv") && fields.length > 1 ? ["x", "y", "z"] : [];
    row.querySelector(".tp-colswv_b")?.setAttribute("aria-label", `choose ${label}`);
    for (const [i, field] of fields.entries()) {
      field.setAttribute("aria-label", axes[i] === undefined ? label : `${label} ${axes[i]}`);
    }
  }
}
