#include "app/help/help.h"

namespace flatray {
namespace {

constexpr WrittenTopic kTopics[] = {
    {"camera", "what part of the world is shown",
     R"(The window is film.world, or what the scene holds in frame 1 and 5 %, grown to the shape of
the picture. The camera moves it: at and height place it, follow keeps an entity in its
middle, velocity drives it. Frame k shows the time (k - 1) / fps.
  camera = { follow = "kite", offset = [2, 0], height = 9 }
)",
     "camera"},
    {"colours", "how colours are written and blended",
     R"("#rrggbb" or "#rrggbbaa": sRGB, straight alpha, ff for opaque. Blending is done on linear
light: half of black over white is #bcbcbc, not #808080. fill = "none" leaves a fill out.
A PNG holds sRGB; .hdr and .pfm hold linear light.
)"},
    {"determinism", "what makes two renders equal, byte for byte",
     R"(A picture is named by the scene (its text, what it imports, -D), the frame and the seed.
Threads, shards, resuming, the machine and its instruction set (FLATRAY_ISA) change no byte.
Random numbers are counted, not drawn in order: frame 17 alone equals frame 17 of the run.
Decisions are exact for the doubles given; there is no tolerance to set.
  flatray compare a.png b.png      # exit code 0: equal, 1: different
)"},
    {"environment", "variables that are read",
     R"(FLATRAY_SIZE=320x200 stands for --size 320x200, and so for every option: upper case, _ for -.
A flag is set by 1, true, yes or on. The command line wins; other names are warned of.
FLATRAY_ISA=portable, baseline, avx2 or avx512 chooses the instruction set. CI refuses golden update.
)"},
    {"exit-codes", "what a script can tell", R"(  0    done
  1    the answer is no: pictures differ, a law does not hold
  2    usage: an option or operand is wrong
  3    an input is missing or cannot be read
  4    an input is read but wrong; every mistake of a scene is told, also by flatray check
  5    a part is not in this build
  6    an output cannot be written
  70   out of memory; or a bug of flatray: please report it
  124  what --max-seconds or --max-memory allow is used up
  130  interrupted, 143 terminated, 129 hung up: what is written is whole, and --resume goes on
)"},
    {"formats", "files that are read",
     R"(The extension says what a file is; from standard input (-) its content does.
  .toml         flatray's own scenes: flatray help scene
  .obj, .obj2d  Wavefront outlines, as a scene or as shape = { import = { file = ... } }
  .txt, .list   the paper's objects, a line { NAME, x, y } each
  .chamber      Hill's chambers: a count, then sides, colour and vertices of each
  .json         scenes of High Quality Zen; one a line is an animation
What an import cannot honour is listed on standard error. flatray list formats: this build's.
)",
     "import"},
    {"frames", "which frames are drawn",
     R"(frames = 48 makes a scene a sequence; frame k shows the time (k - 1) / fps, frame 1 the start.
  -f 17            only frame 17
  -f 1..240:2,300  every second one of 1 to 240, and 300
  --shard 0/3      every third frame from the first; 1/3 and 2/3 elsewhere
  --resume         keeps the frames that are there, whole and of this very scene
Frames are independent: any order, any machine, the same bytes. frames says how many are drawn
unasked; any other can be asked for, of collide and orbit, too. Runs of one scene may share
a folder; one of another scene or seed is refused while they draw the same pattern.
flatray verify FOLDER says whether all frames are as recorded.
)"},
    {"hill", "Hill's chambers: rooms and pillars as bare numbers",
     R"(A .chamber file holds numbers between blanks and ends of lines: how many polygons; for each of
them how many sides, red, green, blue from 0 to 1, and x y of each vertex. The first is the
chamber, the others its pillars; all are convex, all are mirrors:
  2
  4  0.2 0.2 0.3   0 0  8 0  8 6  0 6
  3  0.8 0.4 0.2   2 2  4 2  3 4
The file names no ray: one starts in the mean of the chamber's corners, in direction (1, 0.375),
and bounces 30 times. -D ray.0.at=[1,1] -D ray.0.direction=[1,2] -D ray.0.bounces=9 change it;
flatray convert ROOM.chamber room.toml writes all of it as a scene to go on with.
  flatray render scenes/imported/hill_room.chamber
)"},
    {"limits", "how large a scene and its pictures may be",
     R"(What is larger is refused before memory is taken for it; an option moves each limit.
  --max-pixels    of a picture: 268435456
  --max-entities  copies and lines of a list too, and as many groups, pillars and rays: 1000000
  --max-corners   kept with all copies, and drawn in one frame with all dashes: 33554432
  --max-depth     groups in groups, and files in files: 64
  --max-bytes     of a scene with all files it names: 1073741824
  --max-memory    of the program, as 500M or 2G; --max-seconds: none
A scene keeps about 24 bytes a corner and 600 an entity, a frame 60 bytes a corner drawn,
twice where frames follow one another; chains at most 64 MB of states, and 32 bytes each.
Reading takes some 35 bytes for each of TOML, 300 for each of HQZ's JSON, until the scene is there.
flatray render --dry-run SCENE says what pictures take besides.
)"},
    {"markov", "chains that choose looks at random, by the seed",
     R"(A chain has a row for each state; a row sums to 1. It draws once every hold frames; an entity
or lamp that uses it has the look of its state, several looks one a frame. --seed N, another walk.
  [markov.paper]
  STANDING = { STANDING = 0.15, RUNNING = 0.85 }
  RUNNING  = { RUNNING = 1 }
flatray experiment markov SCENE compares a million walks with the closed form.
)",
     "markov.NAME entity.markov entity.states lamp.states"},
    {"output", "where pictures go",
     R"(Without -o: out/SCENE.png, or out/SCENE/frame_####.png for a sequence.
  -o 'out/frame_####.png'     the number of the frame, as many digits as #
  -o 'out/{scene}/%04d.png'   the same, with the scene's name
  -o picture.hdr              linear light; .pfm: every float as it is
  -o light.film               light of lamps, to which --resume and merge add more
  -o -                        one picture on standard output
  -o video.mp4                all frames in one file, by ffmpeg: .webm, .gif; .y4m
  -o - --format y4m           all frames for other programs, as ffmpeg -i -
A picture appears under its name when it is whole. manifest.jsonl beside it has a line for
each: frame, file, hash of its pixels, of the scene, the seed. Inputs, links and files of
another kind are replaced only with --force.
)"},
    {"overrides", "changing a scene from the command line",
     R"(-D KEY=VALUE sets one key: a dotted path and a value in TOML. Entries of a list are chosen by
number from 0 or by name.
  -D film.size=[320,180]   -D entity.runner.at=[3,4]   -D 'film.background="#000000"'
)"},
    {"safety", "scenes and folders of strangers",
     R"(A scene reads files beneath the folder the command runs in if it lies there itself, else beneath
its own; a flatray.toml names places in its own folder. Control characters are shown as escapes,
and texts of a scene are no formulas in CSV.
  --root DIR   nothing outside of DIR is read or written; --root / lets a scene refer to all
  --sandbox    the kernel refuses all files that the command line does not name or imply
               (Linux 5.13; exit code 5 elsewhere)
docs/SCENE_FORMAT.md, "Scenes of strangers", says what is promised.
)"},
    {"scene", "what a scene file looks like",
     R"(TOML: key = value, [table], [[table in a list]], # comment. The smallest scene:
  flatray = 1
  [[entity]]
  shape = { circle = { radius = 1 } }
flatray help TABLE shows the keys of one, as in: flatray help entity. scenes/tutorial builds
up from one segment; docs/SCENE_FORMAT.md says all; flatray schema serves editors.
)",
     "scene"},
    {"shapes", "what an entity, chamber or pillar can be",
     R"(shape = { KIND = { ... } }, exactly one kind; flatray help KIND shows its arguments, and
flatray list shapes all of them. Shapes lie in coordinates of their own: at is where the
origin goes, about which they turn.
)"},
};

}  // namespace

std::vector<WrittenTopic> written_topics() { return {std::begin(kTopics), std::end(kTopics)}; }

}  // namespace flatray
