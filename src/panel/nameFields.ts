/** Gives every field below an element the name that its row shows: Tweakpane's labels are for the eye only. */
export function nameFields(element: HTMLElement): void {
  for (const row of element.querySelectorAll(".tp-lblv")) {
    const label = row.querySelector(".tp-lblv_l")?.textContent;
    if (!label) continue;
    const fields = [...row.querySelectorAll("input, select, textarea")];
    const axes = row.querySelector(".tp-pndtxtv") && fields.length > 1 ? ["x", "y", "z"] : [];
    row.querySelector(".tp-colswv_b")?.setAttribute("aria-label", `choose ${label}`);
    for (const [i, field] of fields.entries()) {
      field.setAttribute("aria-label", axes[i] === undefined ? label : `${label} ${axes[i]}`);
    }
  }
}
