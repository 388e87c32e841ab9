// Grazing scenes through every flow: which events are missed, which are invented.
#pragma once
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <thread>

#include "support/grazing_scenes.hpp"
#include "support/reference.hpp"
#include "support/sign_change_run.hpp"

namespace mariotte::test {

struct Tally {
  std::size_t scenes = 0, missed = 0, ghosts = 0, failed = 0;
};

inline const char* const sign_change = "sign change only";

struct GrazeCampaign {
  std::map<std::pair<std::string, double>, Tally> rows;  ///< by flow and accuracy
  std::size_t losing = 0, keeping = 0;                   ///< scenes whose graze is an event, and is none
  std::vector<std::string> wrong;                        ///< scenes that a flow of the library got wrong

  void add(const std::string& flow, std::size_t index, const GrazingScene& scene,
           const std::vector<std::size_t>& found, const std::string& message) {
    auto& row = rows[{flow, scene.accuracy}];
    ++row.scenes;
    std::size_t missed = 0, ghosts = 0;
    const auto& truth = scene.truth.periods;
    for (std::size_t j = 0; j < found.size(); ++j) {
      missed += truth[j] - std::min(truth[j], found[j]);
      ghosts += found[j] - std::min(truth[j], found[j]);
    }
    row.missed += missed;
    row.ghosts += ghosts;
    row.failed += found.empty();
    if (flow == sign_change || (missed + ghosts == 0 && !found.empty())) return;
    std::ostringstream text;
    text << "scene " << index << " by " << flow << " at " << scene.accuracy << ": contact " << scene.contact
         << " grazes to " << scene.depth << "; missed " << missed << ", ghosts " << ghosts << " " << message;
    wrong.push_back(text.str());
  }
};

inline void run_scene(GrazeCampaign& campaign, std::size_t index, const std::vector<std::string>& flows) {
  const auto scene = grazing_scene(index);
  ++(scene.depth > 0 ? campaign.losing : campaign.keeping);
  for (const auto& flow : flows) {
    const auto impact = impact::simulate(
        scene.chain, {.accuracy = scene.accuracy, .max_time = scene.until, .flow = flow::parse_kind(flow)});
    const bool failed = impact.ending == hybrid::Ending::failed;
    campaign.add(flow, index, scene, failed ? std::vector<std::size_t>{} : period_counts(impact),
                 impact.message);
  }
  const double end = scene.chain.gravity == 0 ? scene.truth.time : scene.until;
  campaign.add(sign_change, index, scene, SignChangeRun(scene.chain).periods(scene.accuracy, end), {});
}

inline void append(GrazeCampaign& all, const GrazeCampaign& part) {
  all.losing += part.losing;
  all.keeping += part.keeping;
  all.wrong.insert(all.wrong.end(), part.wrong.begin(), part.wrong.end());
  for (const auto& [key, row] : part.rows) {
    auto& sum = all.rows[key];
    sum.scenes += row.scenes;
    sum.missed += row.missed;
    sum.ghosts += row.ghosts;
    sum.failed += row.failed;
  }
}

/// The first `scenes` scenes, shared among the processors.
inline GrazeCampaign run_campaign(std::size_t scenes, const std::vector<std::string>& flows) {
  const std::size_t workers = std::max(1u, std::thread::hardware_concurrency());
  std::vector<GrazeCampaign> parts(workers);
  std::vector<std::thread> threads;
  for (std::size_t worker = 0; worker < workers; ++worker)
    threads.emplace_back([&, worker] {
      for (std::size_t i = worker; i < scenes; i += workers) run_scene(parts[worker], i, flows);
    });
  for (auto& thread : threads) thread.join();
  GrazeCampaign all;
  for (const auto& part : parts) append(all, part);
  return all;
}

inline std::ostream& operator<<(std::ostream& out, const GrazeCampaign& campaign) {
  out << campaign.losing << " scenes with an event at the graze, " << campaign.keeping << " without\n"
      << std::left << std::setw(20) << "flow" << std::right << std::setw(10) << "accuracy" << std::setw(9)
      << "scenes" << std::setw(9) << "missed" << std::setw(9) << "ghosts" << std::setw(9) << "failed" << '\n';
  for (const auto& [key, row] : campaign.rows)
    out << std::left << std::setw(20) << key.first << std::right << std::setw(10) << key.second
        << std::setw(9) << row.scenes << std::setw(9) << row.missed << std::setw(9) << row.ghosts
        << std::setw(9) << row.failed << '\n';
  return out;
}

}  // namespace mariotte::test
