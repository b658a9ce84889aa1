// needs: shapes/box
#include "app/frames/render_job.h"

#include <unistd.h>

#include <filesystem>

#include "support/pictures.h"

namespace flatray {
namespace {

// Two runs of one setting that planned to make the same frames: what one has made meanwhile stays recorded
// when the other begins.
TEST(RenderJob, RecordsThatARunOfTheSameSettingAddsMeanwhileStay) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ("flatray_twice" + std::to_string(getpid()));
  const Scene scene = scene_of(
      "flatray = 1\nframes = 4\nfilm = { size = [8, 8], world = [[0, 0], [16, 8]] }\n[[entity]]\n"
      "name = \"box\"\nshape = { box = { min = [0, 0], max = [5, 4] } }\nvelocity = [12, 0]\n");
  const auto output = OutputPattern::parse((folder / "####.png").string(), std::nullopt, {});
  const RenderJob job{scene, "boxes", *output, {1, 2, 3, 4}, 4, {}, {}, 0, false};
  const Outputs outputs;
  const auto run = [&](const Work& work, const std::function<void()>& done) {
    const auto hold = hold_pattern(job, outputs);
    ASSERT_TRUE(hold);
    EXPECT_EQ(run_job(work, 1, done, &*hold).written.size(), 4U);
  };
  const auto records = [&] { return records_of(Journal(job.manifest()).read().value()).size(); };
  run(plan_work(job, true, 1).value(), [] {});
  std::filesystem::remove(job.path(2));
  run(plan_work(job, false, 1).value(), [] {});  // all anew
  const Work planned = plan_work(job, false, 1).value();
  std::vector<std::size_t> there;
  run(planned, [&] { there.push_back(records()); });
  EXPECT_EQ(there, (std::vector<std::size_t>{1, 2, 3, 4})) << "they were there when it planned";
  std::filesystem::remove_all(folder);
  const Work first = plan_work(job, true, 1).value(), second = first;
  run(first, [] {});
  there.clear();
  run(second, [&] { there.push_back(records()); });
  EXPECT_EQ(there, (std::vector<std::size_t>{4, 4, 4, 4}));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace flatray
