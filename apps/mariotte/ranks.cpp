#include "ranks.hpp"

#include <cstdlib>
#include <numeric>

#include "command_line/exit_code.hpp"

#ifdef MARIOTTE_MPI
#include <mpi.h>
#endif

namespace mariotte::command {
namespace {

bool launched_by_mpi() {
  for (const auto* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv(variable)) return true;
  return false;
}

}  // namespace

Index Ranks::tell(Index done) {
  const auto own = static_cast<std::size_t>(rank_);
  const bool news = done_[own] != done;
  done_[own] = done;
  if (joined_ && (news || first())) collect();
  return first() ? std::accumulate(done_.begin(), done_.end(), Index{0}) : done;
}

#ifdef MARIOTTE_MPI

namespace {

constexpr int progress_tag = 1;

}  // namespace

Ranks::Ranks() {
  if (launched_by_mpi()) {
    // Only the thread that joined talks to the others.
    int provided = 0, rank = 0, count = 1;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    rank_ = rank;
    count_ = count;
    joined_ = true;
  }
  done_.resize(static_cast<std::size_t>(count_));
}

Ranks::~Ranks() {
  if (!joined_) return;
  meet();
  if (first()) collect();
  MPI_Finalize();
}

void Ranks::end_all(int code) const {
  MPI_Abort(MPI_COMM_WORLD, code);
  std::_Exit(code);
}

void Ranks::meet() const {
  if (joined_) MPI_Barrier(MPI_COMM_WORLD);
}

void Ranks::collect() {
  if (!first()) {
    MPI_Send(&done_[static_cast<std::size_t>(rank_)], 1, MPI_LONG_LONG, 0, progress_tag, MPI_COMM_WORLD);
    return;
  }
  for (int waiting = 1; waiting != 0;) {
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, progress_tag, MPI_COMM_WORLD, &waiting, &status);
    if (waiting)
      MPI_Recv(&done_[static_cast<std::size_t>(status.MPI_SOURCE)], 1, MPI_LONG_LONG, status.MPI_SOURCE,
               progress_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  }
}

#else

Ranks::Ranks() : done_(1) {
  if (launched_by_mpi())
    throw UsageError("this program was built without MPI and cannot run under mpirun", fault::not_installed);
}
Ranks::~Ranks() = default;
void Ranks::end_all(int code) const {
  std::_Exit(code);
}
void Ranks::meet() const {}
void Ranks::collect() {}

#endif

}  // namespace mariotte::command
