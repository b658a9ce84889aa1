#include "scene/reading/spectrum_text.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/counted.h"
#include "base/number_text.h"
#include "scene/reading/format.h"

namespace flatray {
namespace {

constexpr const char* kHint = "a line reads WAVELENGTH, POWER, as 589.3, 0.75";

class SpectrumReader {
 public:
  explicit SpectrumReader(SourcePtr source) : source_(std::move(source)) {}

  Result<Spectrum> read() {
    std::string_view rest = source_->text();
    if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
    while (!rest.empty() && problems_.size() < kMostProblems && rows_.size() <= kMostSpectrumRows) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      read_line(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (problems_.empty()) check_rows();
    if (!problems_.empty()) return tl::unexpected(std::move(problems_));
    Spectrum spectrum(in_parts());
    if (spectrum.colour() != LightColour{0, 0, 0}) return spectrum;
    return fail(whole(), "the spectrum has no light between 380 and 780 nm",
                "wavelengths are in nanometres: 0.55 micrometres are 550");
  }

 private:
  Place place(std::string_view part) const { return place_in(source_, part); }
  Place whole() const { return {source_, 0, 1}; }
  void problem(std::string_view part, std::string message, const char* hint = kHint) {
    problems_.push_back({place(part), std::move(message), hint});
  }

  static std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    const bool parted = line.find_first_of(",;") != std::string_view::npos;
    for (;;) {
      const std::size_t end = line.find_first_of(parted ? ",;" : " \t");
      fields.push_back(trimmed(line.substr(0, end)));
      if (end == std::string_view::npos) return fields;
      line = line.substr(end + 1);
      if (!parted) line = trimmed(line);
    }
  }

  void read_line(std::string_view line) {
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) return;
    const std::vector<std::string_view> fields = fields_of(line);
    const bool may_be_names = !std::exchange(begun_, true);
    const bool begins_a_number =
        !fields.front().empty() &&
        std::string_view("+-.0123456789").find(fields.front()[0]) != std::string_view::npos;
    if (may_be_names && !begins_a_number) return;
    if (fields.size() != 2)
      return problem(line, fmt::format("a row has {}, not a wavelength and a power",
                                       counted(fields.size(), "column")));
    double numbers[2] = {0, 0};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto number = parse_number(fields[i]);
      if (!number)
        return problem(fields[i].empty() ? line : fields[i],
                       fmt::format("'{}' is not a finite number", fields[i].substr(0, 40)));
      numbers[i] = *number;
    }
    add(fields, {numbers[0], numbers[1]});
  }

  void add(const std::vector<std::string_view>& fields, const Spectrum::Row& row) {
    if (!(row.nm > 0))
      problem(fields[0], fmt::format("wavelength {} is not above 0", number_text(row.nm)));
    else if (!rows_.empty() && !(row.nm > rows_.back().nm))
      problem(fields[0],
              fmt::format("wavelength {} does not lie above {}, that before it",
                          number_text(row.nm), number_text(rows_.back().nm)),
              "put the rows in the order of their wavelengths, each once");
    else if (!(row.power >= 0))
      problem(fields[1], fmt::format("power {} is below 0", number_text(row.power)),
              "write 0 where there is no light");
    rows_.push_back(row);
  }

  void check_rows() {
    if (rows_.size() < 2) problems_.push_back({whole(), "a spectrum has two rows at least", kHint});
    if (rows_.size() > kMostSpectrumRows)
      problems_.push_back({whole(),
                           "the spectrum has more than " + counted(kMostSpectrumRows, "row"),
                           "leave rows out: what lies between them is in proportion"});
  }

  // Of the most powerful row.
  std::vector<Spectrum::Row> in_parts() const {
    std::vector<Spectrum::Row> rows = rows_;
    double most = 0;
    for (const Spectrum::Row& row : rows) most = std::max(most, row.power);
    if (most > 0)
      for (Spectrum::Row& row : rows) row.power /= most;
    return rows;
  }

  SourcePtr source_;
  bool begun_ = false;
  std::vector<Spectrum::Row> rows_;
  Diagnostics problems_;
};

}  // namespace

Result<Spectrum> parse_spectrum(const SourcePtr& source) { return SpectrumReader(source).read(); }

}  // namespace flatray
