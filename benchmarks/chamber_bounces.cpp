// Goal S2 on one thread and on two: 1024 rays bouncing 200 times in a room of N mirrors, in million bounces a second.
// `flatray, orbits` is the product: exact walls and points that never leak; the others share one plain loop that
// reflects in doubles and lets rays leak.
//   chamber_bounces [--most N]
#include <cstring>
#include <functional>
#include <thread>

#include "chamber.h"
#include "transport/orbit_tracer.h"

namespace {

class Nothing : public flatray::OrbitSink {
 public:
  void bounce(std::size_t, const flatray::Bounce&) override {}
  void end(std::size_t, const flatray::OrbitStop&) override {}
};

// One contender, made ready for each of two threads.
struct Loop {
  std::string name;
  std::vector<std::function<void()>> of_thread;
  std::vector<double> cpu[2] = {}, wall[2] = {};  // rates by round, of one thread and of two
};

class Stage {
 public:
  explicit Stage(std::size_t segments)
      : room_(bench::room(segments, bench::kUniform)),
        mirrors_(room_.walls.size(), flatray::Material::mirror),
        orbits_(room_.walls, mirrors_) {
    const flatray::RayBatch rays = bench::random_rays(Chamber::kBlock, room_.side, 7);
    for (std::size_t i = 0; i < rays.size(); ++i) starts_.push_back({rays.ray(i)});
    loops_.push_back({"flatray, orbits", {}});
    for (int thread = 0; thread < 2; ++thread) {
      loops_[0].of_thread.emplace_back([this] {
        Nothing sink;
        orbits_.follow(starts_, Chamber::kBounces, sink);
      });
      bench::Tracings all;
      all.push_back(std::make_unique<bench::Flatray>(*flatray::choose_tracer(room_.walls).tracer,
                                                     room_.walls));
#ifdef BENCH_EMBREE
      bench::add_embree(room_.walls, 0.5, all);
#endif
      for (auto& one : all)
        if (one->for_chambers()) add(std::move(one), thread);
    }
  }

  void run(int rounds) {
    for (int round = 0; round <= rounds; ++round)
      for (Loop& loop : loops_)
        for (int threads = 1; threads <= 2; ++threads) turn(loop, threads, round > 0);
  }

  void print() const {
    double best = 0;
    for (const Loop& loop : loops_)
      if (loop.name.starts_with("Embree")) best = std::max(best, bench::median(loop.cpu[0]));
    for (const Loop& loop : loops_) {
      const double one = bench::median(loop.cpu[0]), two = bench::median(loop.cpu[1]);
      fmt::print("| {:7} | {:24} | {:8.3f} | {:8.3f} | {:8.3f} | {:>5} |\n", room_.walls.size(),
                 loop.name, one, two, bench::median(loop.wall[1]),
                 best > 0 ? fmt::format("{:.2f}", one / best) : "");
    }
    std::fflush(stdout);
  }

 private:
  using Chamber = bench::Chamber;

  void add(std::unique_ptr<bench::Tracing> tracing, int thread) {
    tracings_.push_back(std::move(tracing));
    chambers_.push_back(std::make_unique<Chamber>(*tracings_.back(), room_));
    const std::string name = tracings_.back()->name();
    auto loop = std::find_if(loops_.begin(), loops_.end(),
                             [&](const Loop& other) { return other.name == name; });
    if (thread == 0) loop = loops_.insert(loops_.end(), Loop{name, {}});
    loop->of_thread.emplace_back([chamber = chambers_.back().get()] { chamber->run(); });
  }

  static void turn(Loop& loop, int threads, bool counts) {
    constexpr double kMillions = 1e-6 * Chamber::kBlock * Chamber::kBounces;
    double rates[2] = {};
    const double start = bench::seconds(CLOCK_MONOTONIC);
    {
      std::vector<std::jthread> running;
      for (int i = 0; i < threads; ++i)
        running.emplace_back([&loop, &rates, i] {
          const double before = bench::seconds(CLOCK_THREAD_CPUTIME_ID);
          loop.of_thread[static_cast<std::size_t>(i)]();
          rates[i] = kMillions / (bench::seconds(CLOCK_THREAD_CPUTIME_ID) - before);
        });
    }
    if (!counts) return;
    loop.cpu[threads - 1].push_back(rates[0] + rates[1]);
    loop.wall[threads - 1].push_back(threads * kMillions /
                                     (bench::seconds(CLOCK_MONOTONIC) - start));
  }

  bench::Room room_;
  std::vector<flatray::Material> mirrors_;
  flatray::OrbitTracer orbits_;
  std::vector<flatray::OrbitStart> starts_;
  std::vector<std::unique_ptr<bench::Tracing>> tracings_;
  std::vector<std::unique_ptr<Chamber>> chambers_;
  std::vector<Loop> loops_;
};

}  // namespace

int main(int count, char** arguments) {
  std::size_t most = 65536;
  if (count == 3 && std::strcmp(arguments[1], "--most") == 0) most = std::stoul(arguments[2]);
  fmt::print(
      "\nS2: million bounces a second, medians of rounds in turn. By CPU time of one thread; of "
      "two "
      "threads\ntogether; by wall time of two. Ratio: one thread to the best of Embree.\n"
      "|       N | who                      |      one |      two | two wall | ratio |\n"
      "|---|---|---|---|---|---|\n");
  for (const std::size_t segments : {16UL, 256UL, 4096UL, 65536UL}) {
    if (segments > most) continue;
    Stage stage(segments);
    stage.run(7);
    stage.print();
  }
}
