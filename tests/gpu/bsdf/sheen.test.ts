import { expect, test } from "vitest";
import { deviceSheenAlbedo } from "../../support/deviceSheen";
import { charlieAlbedo, LEAST_SHEEN_ROUGHNESS } from "../../support/khrMaterials";
import { recordStability } from "../../support/stabilityRows";

// Between the rows and columns of the table too: 1 roughness and 2 angles.
const ROUGHNESS = Array.from({ length: 31 }, (_, i) => LEAST_SHEEN_ROUGHNESS + ((1 - LEAST_SHEEN_ROUGHNESS) * i) / 30);
const COSINES = [1e-9, 1e-6, 1e-4, ...Array.from({ length: 44 }, (_, i) => ((i + 2) / 45) ** 3)];
const GRID = ROUGHNESS.flatMap((roughness) => COSINES.map((cosine) => ({ roughness, cosine })));

test("the table of what fibres reflect is never below the truth, and above it by as much as it says", async () => {
  const table = await deviceSheenAlbedo(GRID.map(({ cosine, roughness }) => [cosine, roughness] as const));
  let [least, most, mostGrazing, mostNarrow] = [1, 0, 0, 0];
  for (const [i, { roughness, cosine }] of GRID.entries()) {
    const excess = table[i]! - charlieAlbedo(cosine, roughness ** 2, 64);
    least = Math.min(least, excess);
    if (roughness < 0.2) mostNarrow = Math.max(mostNarrow, excess);
    else if (cosine < 1e-3) mostGrazing = Math.max(mostGrazing, excess);
    else most = Math.max(most, excess);
  }
  const found = [least, most, mostGrazing, mostNarrow].map((value) => value.toExponential(1));
  console.log(
    `sheen's table above quadrature: least and most, at grazing angles, of narrow lobes: ${found.join(", ")}`,
  );
  recordStability("sheen", [
    {
      case: "sheen: the table of what white fibres reflect, against quadrature",
      asserted: "0 to 0.04 above, 0.07 at cosines below 0.001, 0.3 for roughnesses below 0.2",
      inputs: GRID.length,
      worst: most,
    },
  ]);
  expect(least).toBeGreaterThan(-QUADRATURE);
  expect(most).toBeLessThan(0.04);
  expect(mostGrazing).toBeLessThan(0.07);
  expect(mostNarrow).toBeLessThan(0.3);
});

// The midpoint rule on 64², which is above the truth.
const QUADRATURE = 3e-4;
