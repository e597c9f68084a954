import { describePrograms } from "./programs";

describePrograms({ estimator: "uniform", sampler: "independent", lightSamples: 2 });
