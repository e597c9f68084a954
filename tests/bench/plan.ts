/** What a render may take at most, in seconds. A slower renderer takes fewer samples. */
export const CAP_SECONDS = 20;

/** Of a first, short render, which tells how many samples are affordable. */
export function pilotCount(samples: number): number {
  return Math.max(Math.floor(samples / 16), 1);
}

/**
 * The sample counts to render a scene with: `samples` and a quarter, a sixteenth and a 64th of them, as far as affordable.
 * If `samples` is not, the largest power of two that is takes its place.
 */
export function sampleCounts(samples: number, secondsPerSample: number): number[] {
  const affordable = Math.max(CAP_SECONDS / secondsPerSample, 1);
  const main = samples <= affordable ? samples : 2 ** Math.floor(Math.log2(affordable));
  const counts = [samples / 64, samples / 16, samples / 4].map(Math.floor).filter((n) => n >= 1 && n <= affordable);
  return [...new Set([...counts, main])].sort((a, b) => a - b);
}

/** Which of the counts goes into the table: `samples`, or as near below as there is. */
export function mainCount(counts: readonly number[], samples: number): number {
  return Math.max(...counts.filter((count) => count <= samples));
}
