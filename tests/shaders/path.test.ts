import { describePrograms } from "./programs";

describePrograms({ estimator: "path", sampler: "sobol", lightSamples: 1 });
