declare module "rt-viewer/scene.schema.json" {
  /** JSON Schema of scene files, draft 7. */
  const schema: { readonly [keyword: string]: unknown };
  export default schema;
}
