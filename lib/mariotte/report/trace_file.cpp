#include "mariotte/report/trace_file.hpp"

#include "mariotte/report/csv/csv.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::report {
namespace {

class CsvTrace final : public TraceFile {
 public:
  CsvTrace(const std::filesystem::path& path, const std::vector<Index>& balls,
           const std::vector<Index>& contacts)
      : file_(path, part_name(path)) {
    file_.append(trace_header(balls, contacts));
  }
  void add(const impact::Sample& sample) override {
    file_.append(trace_row(sample.time, sample.velocity, sample.gap, sample.force));
  }
  void commit() override { file_.commit(); }
  std::filesystem::path leave() override { return file_.leave(); }

 private:
  NewFile file_;
};

}  // namespace

std::unique_ptr<TraceFile> new_trace_file(const std::filesystem::path& path, const std::vector<Index>& balls,
                                          const std::vector<Index>& contacts, const Attributes& origin) {
  const auto ending = path.extension();
  if (ending == ".h5" || ending == ".hdf5") return new_hdf5_trace(path, balls, contacts, origin);
  return std::make_unique<CsvTrace>(path, balls, contacts);
}

}  // namespace mariotte::report
