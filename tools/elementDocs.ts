import type { Attribute, CustomElementDeclaration, Package } from "custom-elements-manifest";

/** Tables of the element's attributes, properties, methods, events, slots, parts and custom properties. */
export function describeElement(manifest: Package): string {
  const element = manifest.modules[0]!.declarations![0] as CustomElementDeclaration;
  const { attributes = [], members = [], events = [], slots = [], cssParts = [], cssProperties = [] } = element;
  const code = (text: string | undefined) => (text ? `\`${text.replaceAll("|", "\\|")}\`` : "");
  const described = ({ name, description = "" }: { name: string; description?: string }) => [
    code(name) || "(default)",
    description,
  ];
  return [
    `## \`<${element.tagName}>\``,
    element.description ?? "",
    ...table(
      "Attributes",
      ["attribute", "property", "type", ""],
      attributes,
      ({ name, fieldName, type, description }: Attribute) => [
        code(name),
        code(fieldName),
        code(type?.text),
        description ?? "",
      ],
    ),
    ...table(
      "Properties and methods",
      ["name", "type", ""],
      members.filter((member) => !("attribute" in member)),
      (member) => [
        code(member.kind === "method" ? `${member.name}()` : member.name),
        code(member.kind === "method" ? member.return?.type?.text : member.type?.text),
        member.description ?? "",
      ],
    ),
    ...table("Events", ["event", "type", ""], events, ({ name, type, description }) => [
      code(name),
      code(type.text),
      description ?? "",
    ]),
    ...table("Slots", ["slot", ""], slots, described),
    ...table("Parts", ["part", ""], cssParts, described),
    ...table("Custom properties", ["property", ""], cssProperties, described),
  ].join("\n\n");
}

/** A heading and a table, or nothing if there are no rows. */
function table<Item>(
  title: string,
  head: readonly string[],
  items: readonly Item[],
  cells: (item: Item) => readonly string[],
): string[] {
  if (items.length === 0) return [];
  const rows = [head, head.map(() => "---"), ...items.map(cells)];
  return [
    `### ${title}`,
    rows.map((row) => `| ${row.map((cell) => cell.replaceAll(/\s*\n+\s*/g, " ")).join(" | ")} |`).join("\n"),
  ];
}
