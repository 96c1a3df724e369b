// SPDX-License-Identifier: MIT
// Random mistakes: each keeps the picture, and none leaves a trace after its repair. The first run found a ray pass
// with `termination = luminance` that took minutes to compile.
//
// STROBE_EDITS (100; 1000 with --all), STROBE_EDITS_DRAWN (12; 60) and STROBE_EDITS_SEED (1) set the number of edits,
// the number of drawn pictures and the seed; docs/reload.md has the result for a thousand edits. STROBE_EDITS_REPORT
// names a file for a table of results.
#include "session/edits.h"

#include <cstdlib>

#include "base/log.h"
#include "common/all_cases.h"
#include "lab/record.h"

namespace strobe::session {
namespace edits_test {

using lab::Session;

int fromEnvironment(const char* name, int otherwise) {
  const char* value = std::getenv(name);
  return value ? std::atoi(value) : otherwise;
}

struct Tally {
  int edits = 0, drawn = 0, refused = 0, partly = 0, taken = 0, unnoticed = 0;
};

class Edits : public SessionTest {
 protected:
  // Files that a session of these pipelines can read.
  std::map<std::string, std::string> files() {
    std::map<std::string, std::string> files = home_.all();
    std::erase_if(files, [](const auto& file) {
      bool other = file.first.starts_with("scripts/captures") || file.first.starts_with("scripts/scenes/") ||
                   file.first.starts_with("passes/truth") || file.first.starts_with("shaders/truth") ||
                   file.first.ends_with("types.lua");
      return other;
    });
    return files;
  }

  // After an edit: a refused edit keeps the picture, and an accepted edit gives the picture of a cold start.
  void expectSound(Session& session, const lab::Reload& told, const std::string& good_image, const Edit& edit) {
    std::string image = colorHash(session);
    if (!told.swapped) {
      EXPECT_EQ(image, good_image) << "after a refused edit: " << edit.shown() << "\n" << joined(told.problems);
      return;
    }
    if (!told.problems.empty()) return;
    try {
      Session cold(bench(), session.shot());
      EXPECT_EQ(image, colorHash(cold)) << "after " << edit.shown();
    } catch (const Error& error) {
      ADD_FAILURE() << "a cold start refuses the reloaded files: " << edit.shown() << "\n" << error.what();
    }
  }

  void report(const std::map<std::string, Tally>& tallies, double seconds) {
    const char* file = std::getenv("STROBE_EDITS_REPORT");
    if (!file) return;
    std::string text = "| kind of edit | edits | drawn | refused, picture kept | partly taken | taken | not in use |\n";
    text += "|---|---|---|---|---|---|---|\n";
    for (const auto& [kind, t] : tallies)
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", kind, t.edits, t.drawn, t.refused, t.partly,
                          t.taken, t.unnoticed);
    writeFileAtomically(file, text + fmt::format("\n{:.0f} s in all.\n", seconds));
  }
};

TEST_F(Edits, MistakesKeepThePicture) {
  int count = fromEnvironment("STROBE_EDITS", allCases() ? 1000 : 100);
  int drawn = fromEnvironment("STROBE_EDITS_DRAWN", allCases() ? 60 : 12);
  std::mt19937 random(unsigned(fromEnvironment("STROBE_EDITS_SEED", 1)));
  std::map<std::string, std::string> good = files();
  bench().limits.cpu_s = 0.2;
  double started_s = clockSeconds();
  Session session(bench(), smallShot("hybrid"));
  session.reload(true);
  const std::string image = colorHash(session), plan = session.running().planned().hash;
  std::map<std::string, Tally> tallies;

  for (int i = 0; i < count && !HasFailure(); ++i) {
    Edit edit = randomEdit(random, good);
    Tally& tally = tallies[edit.kind];
    bool draw = i % std::max(1, count / std::max(1, drawn)) == 0;
    ++tally.edits;
    tally.drawn += draw;
    if (edit.kind == "deleted") home_.remove(edit.file);
    else home_.write(edit.file, edit.text, edit.save);
    auto told = session.reload(true);
    if (!told) ++tally.unnoticed;
    else if (!told->problems.empty()) ++(told->swapped ? tally.partly : tally.refused);
    else ++tally.taken;
    if (draw && told) expectSound(session, *told, image, edit);

    home_.write(edit.file, good.at(edit.file), Save(i % 3));
    session.reload(true);
    EXPECT_TRUE(session.problems().empty()) << "after mending " << edit.shown() << "\n" << joined(session.problems());
    EXPECT_EQ(session.running().planned().hash, plan) << "after mending " << edit.shown();
    if (draw) {
      EXPECT_EQ(colorHash(session), image) << "after mending " << edit.shown();
    }
    EXPECT_EQ(joined(bench().device().takeMessages()), "") << edit.shown();
  }
  EXPECT_EQ(colorHash(session), image);
  Session cold(bench(), session.shot());
  EXPECT_EQ(hashes(cold.draw()), hashes(session.draw()));
  bench().limits = {};
  report(tallies, clockSeconds() - started_s);
}

}  // namespace edits_test
}  // namespace strobe::session
