#include "mariotte/report/trace_file.hpp"

#include "mariotte/report/csv/csv.hpp"
#include "mariotte/report/csv/csv_metadata.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::report {
namespace {

class CsvTrace final : public TraceFile {
 public:
  CsvTrace(const std::filesystem::path& path, const std::vector<Index>& balls,
           const std::vector<Index>& contacts, const Attributes& origin)
      : path_(path), header_(trace_header(balls, contacts)), origin_(origin), file_(path, part_name(path)) {
    file_.append(header_);
  }
  void add(const impact::Sample& sample) override {
    file_.append(trace_row(sample.time, sample.velocity, sample.gap, sample.force));
  }
  void commit() override {
    file_.commit();
    describe(path_);
  }
  std::filesystem::path leave() override {
    auto left = file_.leave();
    describe(left);
    return left;
  }

 private:
  void describe(const std::filesystem::path& csv) const {
    write_file(metadata_name(csv), trace_metadata(csv.filename().string(), header_, origin_));
  }

  std::filesystem::path path_;
  std::string header_;
  Attributes origin_;
  NewFile file_;
};

}  // namespace

std::unique_ptr<TraceFile> new_trace_file(const std::filesystem::path& path, const std::vector<Index>& balls,
                                          const std::vector<Index>& contacts, const Attributes& origin) {
  const auto ending = path.extension();
  if (ending == ".h5" || ending == ".hdf5") return new_hdf5_trace(path, balls, contacts, origin);
  return std::make_unique<CsvTrace>(path, balls, contacts, origin);
}

}  // namespace mariotte::report
