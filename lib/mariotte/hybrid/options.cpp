#include "mariotte/hybrid/options.hpp"

#include "mariotte/core/error.hpp"

namespace mariotte::hybrid {

void validate(const Options& options) {
  if (!(options.accuracy > 0 && options.accuracy < 1))
    throw InvalidParameter("accuracy must lie between 0 and 1");
  if (!(options.max_time > 0))
    throw InvalidParameter(options.flies_on ? "until must be positive" : "max_time must be positive");
  if (options.max_events < 1) throw InvalidParameter("max_events must be at least 1");
  if (options.flow == flow::Kind::ballistic)
    throw InvalidParameter("the flow 'ballistic' follows no contact", fault::unknown_word);
}

}  // namespace mariotte::hybrid
