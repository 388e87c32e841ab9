#include "mariotte/flow/choose.hpp"

#include <string>

#include "mariotte/core/error.hpp"
#include "mariotte/flow/ballistic.hpp"
#include "mariotte/flow/cvode.hpp"
#include "mariotte/flow/modal.hpp"
#include "mariotte/flow/pair.hpp"
#include "mariotte/flow/taylor.hpp"

namespace mariotte::flow {
namespace {

/// Above this damping ratio c/√(k m) BDF needs fewer evaluations than Adams.
constexpr double stiff_damping = 5;
/// Up to so many closed contacts, natural modes and their root search cost less than integration.
constexpr std::size_t modal_contacts = 24;
/// Up to this size a dense matrix costs less than a band.
constexpr Index dense_size = 12;

std::unique_ptr<Flow> make(Kind kind, const Problem& problem) {
  switch (kind) {
    case Kind::ballistic:
      return std::make_unique<Ballistic>();
    case Kind::pair:
      return std::make_unique<Pair>();
    case Kind::modal:
      return std::make_unique<Modal>();
    case Kind::taylor:
      return std::make_unique<Taylor>();
    case Kind::cvode_adams:
      return std::make_unique<Cvode>(CvodeMethod::adams, problem);
    case Kind::cvode_bdf_dense:
      return std::make_unique<Cvode>(CvodeMethod::bdf_dense, problem);
    case Kind::cvode_bdf_band:
      return std::make_unique<Cvode>(CvodeMethod::bdf_band, problem);
    case Kind::cvode_bdf_klu:
      return std::make_unique<Cvode>(CvodeMethod::bdf_klu, problem);
  }
  throw Error("unknown kind of flow");
}

/// True of flows that follow some phases only; where they do not, another takes over.
bool exact(Kind kind) {
  return kind == Kind::pair || kind == Kind::modal || kind == Kind::taylor;
}

}  // namespace

std::string_view name(Kind kind) {
  constexpr std::array<std::string_view, kinds.size()> names = {
      "ballistic", "pair", "modal", "taylor", "cvode-adams", "cvode-bdf-dense", "cvode-bdf-band", "cvode-bdf-klu"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<Kind> parse_kind(std::string_view text) {
  if (text == "auto") return std::nullopt;
  std::string known = "auto";
  for (const auto kind : kinds) {
    if (kind == Kind::ballistic) continue;
    if (name(kind) == text) return kind;
    known += ", " + std::string(name(kind));
  }
  throw InvalidParameter("unknown flow '" + std::string(text) + "' (one of: " + known + ")");
}

Kind choose(const Problem& problem, std::optional<Kind> requested) {
  if (problem.is_ballistic()) return Kind::ballistic;
  if (requested && !exact(*requested)) return *requested;
  if (requested != Kind::modal && requested != Kind::taylor && problem.pair()) return Kind::pair;
  if (!requested || *requested == Kind::modal)
    if (const auto phase = problem.linear(); phase && (requested || phase->closed.size() <= modal_contacts))
      return Kind::modal;
  if (problem.damping_ratio() < stiff_damping || requested == Kind::taylor)
    return Taylor::admits(problem) ? Kind::taylor : Kind::cvode_adams;
  return problem.size() <= dense_size ? Kind::cvode_bdf_dense : Kind::cvode_bdf_band;
}

Flow& Flows::get(Kind kind, const Problem& problem) {
  auto& flow = flows_[static_cast<std::size_t>(kind)];
  if (!flow || !flow->fits(problem)) flow = make(kind, problem);
  return *flow;
}

}  // namespace mariotte::flow
