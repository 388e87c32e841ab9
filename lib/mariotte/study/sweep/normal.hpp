// The normal distribution, for inputs that scatter.
#pragma once

namespace mariotte::study {

/// z below which a standard normal value lies with this probability; 0 and 1 count as what is nearest to
/// them, so z is finite.
double normal_quantile(double probability);

}  // namespace mariotte::study
