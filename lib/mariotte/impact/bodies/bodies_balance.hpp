// Energy and momentum of bodies: what closes, and what must not be negative.
#pragma once
#include <vector>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/gate.hpp"
#include "mariotte/model/bodies/bodies_system.hpp"

namespace mariotte::impact {

/// What each contact has exchanged and lost until the state x of a mode, and what it stores then.
template <int D>
std::vector<BodyContactHistory> exchanged(const model::BodiesSystem<D>& system, const model::BodiesMode& mode,
                                          ConstState x);

/// Fills in energy and momentum of a result whose contacts and bodies are known; `contacts` are all.
template <int D>
void balance(const model::Bodies& bodies, const model::BodiesSystem<D>& system, ConstState start,
             ConstState end, const std::vector<BodyContactHistory>& contacts, BodiesImpact& impact);

/// What must hold at the end of a run.
template <int D>
std::vector<Balance> balances(const model::BodiesSystem<D>& system, const model::BodiesMode& mode,
                              ConstState start, ConstState end,
                              const std::vector<BodyContactHistory>& contacts, const BodiesImpact& impact,
                              double accuracy);

}  // namespace mariotte::impact
