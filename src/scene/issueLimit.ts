/**
 * Issues that a `SceneError` holds. Nobody reads more lines; a million are one mistake, made a million times. Not in `errors.ts`, of
 * which the single file exports to its loader of glTF what it exports to everyone.
 */
export const MAX_ISSUES = 100;
