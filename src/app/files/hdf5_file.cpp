#include "app/files/hdf5_file.h"

#include <algorithm>
#include <bit>
#include <deque>
#include <limits>

#include "app/hdf5/module.h"
#include "base/module_file.h"
#include "base/npy.h"

namespace flatray {
namespace {

LoadedTable<FlatrayHdf5Module> find_module() {
  return load_table(kHdf5Module, FLATRAY_HDF5_ENTRY, &FlatrayHdf5Module::abi, FLATRAY_HDF5_ABI);
}

// Arrays, and what they point at.
class Arrays {
 public:
  void add_npy(const ExperimentResult::File& file) {
    const NpyHead& head = heads_.emplace_back(head_of_npy(file.content));
    auto& columns = columns_.emplace_back();
    for (const NpyTable::Column& one : head.columns)
      columns.push_back({one.name.c_str(),
                         one.kind == NpyTable::Kind::real ? FLATRAY_HDF5_REAL : FLATRAY_HDF5_WHOLE,
                         8});
    add(file.name.substr(0, file.name.rfind('.')), file.caption, head.shape,
        file.content.data() + head.size);
  }

  void add_measures(const std::vector<Measure>& measures) {
    if (measures.empty()) return;
    std::size_t longest = 1;
    for (const Measure& one : measures) longest = std::max(longest, one.name.size());
    std::string& rows = rows_.emplace_back();
    for (const Measure& one : measures) {
      rows += one.name + std::string(longest - one.name.size(), '\0');
      for (const double number :
           {one.value, one.standard_error.value_or(kNan), one.expected.value_or(kNan)})
        for (int shift = 0; shift < 64; shift += 8)
          rows += static_cast<char>(std::bit_cast<std::uint64_t>(number) >> shift & 0xff);
    }
    columns_.push_back({{"name", FLATRAY_HDF5_TEXT, static_cast<unsigned>(longest)},
                        {"value", FLATRAY_HDF5_REAL, 8},
                        {"standard_error", FLATRAY_HDF5_REAL, 8},
                        {"expected", FLATRAY_HDF5_REAL, 8}});
    add("measures", "what was measured; NaN: no error is known, or nothing is expected",
        {measures.size()}, rows.data());
  }

  const std::vector<FlatrayHdf5Array>& all() const { return all_; }

 private:
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

  // Of the columns added last.
  void add(std::string name, std::string caption, const std::vector<std::uint64_t>& shape,
           const char* numbers) {
    static_assert(sizeof(unsigned long long) == sizeof(std::uint64_t));
    all_.push_back({texts_.emplace_back(std::move(name)).c_str(),
                    texts_.emplace_back(std::move(caption)).c_str(), columns_.back().data(),
                    static_cast<unsigned>(columns_.back().size()),
                    shapes_.emplace_back(shape.begin(), shape.end()).data(),
                    static_cast<unsigned>(shape.size()), numbers});
  }

  std::deque<NpyHead> heads_;
  std::deque<std::vector<FlatrayHdf5Column>> columns_;
  std::deque<std::vector<unsigned long long>> shapes_;
  std::deque<std::string> texts_, rows_;
  std::vector<FlatrayHdf5Array> all_;
};

}  // namespace

Result<void> can_write_hdf5() {
  const auto found = find_module();
  if (found.table != nullptr) return {};
  return fail(named_place("--hdf5"), found.problem,
              "tools/setup --hdf5 installs libhdf5-dev, which it is built from; then build again",
              Trouble::unavailable);
}

Result<ExperimentResult::File> hdf5_file(const std::string& name, const Texts& attributes,
                                         const ExperimentResult& result) {
  Arrays arrays;
  for (const ExperimentResult::File& file : result.files)
    if (file.name.ends_with(".npy")) arrays.add_npy(file);
  arrays.add_measures(result.measures);
  std::vector<FlatrayHdf5Attribute> given;
  for (const auto& [key, text] : attributes) given.push_back({key.c_str(), text.c_str()});
  ExperimentResult::File file{name + ".h5", ""};
  const FlatrayHdf5Module* module = find_module().table;
  const bool written =
      module != nullptr && module->write(
                               arrays.all().data(), static_cast<unsigned>(arrays.all().size()),
                               given.data(), static_cast<unsigned>(given.size()),
                               [](void* to, const char* bytes, unsigned long long count) {
                                 static_cast<std::string*>(to)->assign(bytes, count);
                               },
                               &file.content);
  if (written) return file;
  return fail(named_place(file.name), "the HDF5 library could not make the file", "",
              Trouble::output);
}

}  // namespace flatray
