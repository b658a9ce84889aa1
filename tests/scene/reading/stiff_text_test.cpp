// needs: shapes/polygon shapes/import formats/obj formats/list
#include "scene/scene_text.h"

namespace flatray {
namespace {

const std::string kMark = "\xef\xbb\xbf";

std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

std::string message(const std::string& name, std::string text) {
  const auto got = load_scene_text(name, std::move(text));
  return got ? "" : format(got.error());
}

struct Sample {
  const char *file, *text;
};
constexpr Sample kSamples[] = {
    {"t.toml",
     "flatray = 1\n[[entity]]\nname = \"e\"\nshape = { box = { min = [0, 0], max = [1, 2] "
     "} }\n"},
    {"t.obj", "v 0 0\nv 1 0\nv 1 2\nv 0 2\nf 1 2 3 4\n"},
    {"t.list", "A, 1, 2\nB, 3, 4\n"},
};

TEST(StiffText, E5AByteOrderMarkCrlfAndAMissingLastLineEndChangeNothing) {
  for (const auto& [file, text] : kSamples) {
    const std::string plain = text, open = plain.substr(0, plain.size() - 1);
    const auto wanted = load_scene_text(file, plain);
    ASSERT_TRUE(wanted) << file;
    for (const std::string& form :
         {kMark + plain, with_crlf(plain), open, kMark + with_crlf(open), plain + "\n\r\n"}) {
      const auto got = load_scene_text(file, form);
      ASSERT_TRUE(got) << file << ": " << format(got.error());
      ASSERT_EQ(got->scene.entities.size(), wanted->scene.entities.size()) << file;
      for (std::size_t i = 0; i < got->scene.shapes.size(); ++i)
        EXPECT_EQ(got->scene.shapes[i].vertices, wanted->scene.shapes[i].vertices) << file;
      EXPECT_TRUE(got->warnings.empty()) << file;
    }
  }
}

TEST(StiffText, E5NulAndStrayBytesAreRefusedWhereTheyStand) {
  using namespace std::string_literals;
  EXPECT_NE(message("t.toml", "flatray = 1\nseed = \0001\n"s).find("t.toml:2:8: error: "),
            std::string::npos);
  EXPECT_NE(message("t.toml", "flatray = 1\n# n\xc3\xa9 \xff\n")
                .find("t.toml:2:7: error: this byte is not UTF-8\n    # n\xc3\xa9 \\xff\n"),
            std::string::npos);
  EXPECT_NE(
      message("t.toml", "flatray = 1\nx = \"\xed\xa0\x80\"\n").find("t.toml:2:6: error: this"),
      std::string::npos);
  EXPECT_NE(message("t.toml",
                    "\xff\xfe"
                    "f\0l\0"s)
                .find("t.toml:1:1: error: this byte is not UTF-8"),
            std::string::npos);
  EXPECT_NE(
      message("t.obj", "v 0 0\nv 1 \xff\xfe\n")
          .find("t.obj:2:5: error: '\\xff\\xfe' is not a finite number\n    v 1 \\xff\\xfe\n"),
      std::string::npos);
  EXPECT_NE(
      message("t.obj", "v 0 0\0\n"s).find("t.obj:1:5: error: '0\\u0000' is not a finite number"),
      std::string::npos);
  EXPECT_NE(message("t.list", "A, 1, 2\0\n"s).find("t.list:1:7: error: '2\\u0000'"),
            std::string::npos);
}

// Whatever is opened 100 000 times is refused at a fixed depth: a recursion as deep as the text
// would end the program.
TEST(StiffText, E5NestingIsRefusedAtAFixedDepth) {
  constexpr std::size_t kDeep = 100'000;
  const std::string head = "flatray = 1\n";
  const std::string texts[] = {
      head + "a = " + repeated("[", kDeep),
      head + "a = " + repeated("[", kDeep) + repeated("]", kDeep),
      head + "a = " + repeated("{a=", kDeep),
      head + "a = " + repeated("[{a=", kDeep),
      head + repeated("a.", kDeep) + "a = 1",
      head + repeated("[", kDeep),
      head + "[a" + repeated(".a", kDeep) + "]",
      head + "[[a" + repeated(".'a'", kDeep) + "]]",
      head + "a = { " + repeated("\"a\" . ", kDeep) + "a = 1 }",
  };
  for (const std::string& text : texts) {
    const auto got = load_scene_text("t.toml", text);
    ASSERT_FALSE(got) << text.substr(0, 40);
    EXPECT_EQ(got.error().size(), 1u);
    EXPECT_LT(format(got.error()).size(), 500u);
  }
}

TEST(StiffText, E5NestingInAnOverrideIsRefusedAtAFixedDepth) {
  constexpr std::size_t kDeep = 100'000;
  for (const Override& one :
       {Override{"film", repeated("[", kDeep)}, Override{"film", repeated("{a=", kDeep)},
        Override{repeated("a.", kDeep) + "a", "1"}, Override{"film", repeated("a.", kDeep) + "a"},
        Override{"film", "{" + repeated("a.", kDeep) + "a = 1}"}})
    EXPECT_FALSE(load("flatray = 1\n", {one}).has_value()) << one.key.substr(0, 20);
}

TEST(StiffText, E5AFaceOfMoreThanAMillionCornersIsRefused) {
  const std::string square = "v 0 0\nv 1 0\nv 1 1\nv 0 1\n";
  const std::string found =
      message("t.obj", square + "f" + repeated(" 1 2 3", 333'334) + "\nf 1 x 2");
  EXPECT_NE(found.find("t.obj:5:1: error: 'f' has more than 1000000 vertices"), std::string::npos);
  EXPECT_NE(found.find("t.obj:6:5: error: 'x' is not a vertex number"), std::string::npos);
}

}  // namespace
}  // namespace flatray
