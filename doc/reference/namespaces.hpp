// The modules of the library, for the reference.
#pragma once

/// Numbers, units, vectors, errors: what every module uses.
namespace mariotte {

/// Laws of contact: force, slopes, stored energy; and the sets of contacts that are open or closed.
namespace contact {}

/// Kinds of errors, by their code.
namespace fault {}

/// Following one smooth field to the next event: closed forms, natural modes, Taylor series, CVODE.
namespace flow {}

/// Physical dimensions by name.
namespace dimension {}

/// Phases and events: the loop that any system with modes runs through.
namespace hybrid {}

/// What moves: chains, networks, microbodies; their units, states, modes and phases.
namespace model {}

/// What is asked for: impacts from start to end with their balances, impact laws, tables.
namespace impact {}

}  // namespace mariotte
