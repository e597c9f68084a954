import type { FolderApi } from "tweakpane";
import type { ResolvedMaterial } from "../scene/schema";
import { addFieldKnob, type Edit, type FieldKnob } from "./fieldKnobs";
import { EFFECTS, type Effect, EMISSION, hasMasking, SURFACE } from "./materialTable";
import { nameFields } from "./nameFields";

type Row = {
  readonly blade: { hidden: boolean };
  readonly matters: (material: ResolvedMaterial) => boolean;
};

/** Adds knobs for a material; those that would change nothing as it stands are hidden. */
export function addMaterialKnobs(
  folder: FolderApi,
  material: ResolvedMaterial,
  onChange: (material: ResolvedMaterial) => void,
): void {
  const rows: Row[] = [];
  let now = material;
  const hideUseless = () => {
    for (const { blade, matters } of rows) {
      const hidden = !matters(now);
      if (blade.hidden !== hidden) blade.hidden = hidden;
    }
  };
  const edit: Edit = {
    get now() {
      return now;
    },
    set(next) {
      now = next;
      hideUseless();
      onChange(now);
    },
  };
  const add = (to: FolderApi, knobs: readonly FieldKnob[]) => {
    for (const knob of knobs) {
      rows.push({ blade: addFieldKnob(to, knob, edit), matters: knob.matters ?? (() => true) });
    }
  };

  add(folder, SURFACE);
  rows.push(...addMasking(folder, edit));
  add(folder, EMISSION);
  for (const effect of EFFECTS) {
    const blade = addEffect(folder, effect, (inner) => {
      add(inner, effect.knobs);
      hideUseless();
    });
    rows.push({ blade, matters: effect.matters });
  }
  hideUseless();
}

function addMasking(folder: FolderApi, edit: Edit): Row[] {
  const shown = { masking: edit.now.masking, multiscatter: edit.now.multiscatter };
  const masking = folder
    .addBinding(shown, "masking", { options: { Smith: "smith", "Schlick–Beckmann": "schlick-beckmann" } })
    .on("change", ({ value }) => {
      // Multiple scattering is known for Smith's masking only.
      shown.multiscatter &&= value === "smith";
      edit.set({ ...edit.now, masking: value, multiscatter: shown.multiscatter });
      multiscatter.refresh();
    });
  const multiscatter = folder
    .addBinding(shown, "multiscatter")
    .on("change", ({ value }) => edit.set({ ...edit.now, multiscatter: value }));
  return [
    { blade: masking, matters: hasMasking },
    {
      blade: multiscatter,
      matters: (material) => hasMasking(material) && material.metallic > 0 && material.masking === "smith",
    },
  ];
}

/** A folder whose knobs are made when it is unfolded: most never are, and colour fields take their time. */
function addEffect(folder: FolderApi, { title }: Effect, fill: (folder: FolderApi) => void): FolderApi {
  const inner = folder.addFolder({ title, expanded: false });
  inner.on("fold", () => {
    if (inner.children.length > 0) return;
    fill(inner);
    nameFields(inner.element, title);
  });
  return inner;
}
