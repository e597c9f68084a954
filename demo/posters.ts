/** Shows each viewer's `poster` until there is a picture, behind the canvas, which has none before. */
export function showPosters(): void {
  for (const viewer of document.querySelectorAll<HTMLElement>("rt-viewer[poster]")) {
    if (!("poster" in viewer)) viewer.style.backgroundImage = `url("${viewer.getAttribute("poster")}")`;
  }
}
