const RUNS = 4;

/**
 * By which factor the CPU time of a work grows from `size` to four times the size: 4 if it is linear, 16 if quadratic. The
 * least of several runs each, because others may use the machine.
 *
 * @param size - large enough that it takes some milliseconds.
 */
export async function growthOf(work: (size: number) => unknown, size: number): Promise<number> {
  await work(size); // compiles it
  const [small, large] = [Math.max(await leastMs(work, size), 1), await leastMs(work, 4 * size)];
  return large / small;
}

/** Between 4 and 16: whether a time grows with the size or with its square. */
export const LINEAR = 8;

async function leastMs(work: (size: number) => unknown, size: number): Promise<number> {
  let least = Number.POSITIVE_INFINITY;
  for (let run = 0; run < RUNS; run++) {
    const before = process.cpuUsage();
    await work(size);
    const { user, system } = process.cpuUsage(before);
    least = Math.min(least, (user + system) / 1000);
  }
  return least;
}
