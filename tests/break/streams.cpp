// SPDX-License-Identifier: BSD-3-Clause
// break_streams: spoiled streams into ptaccum, into vcmetrics, and into the pipe of both.
// A tool may refuse a stream; where it ends with status 0, what it says must be what a second reading of the same bytes
// gives (stream_model.h).  So a cut stream, a lost frame or a number that is none can not pass in silence.
#include <cmath>
#include <cstdio>
#include <sstream>

#include "campaign.h"
#include "stream_model.h"
#include "stream_mutations.h"

namespace breaking {
namespace {

struct Seeds {
    std::vector<std::string> frames, sums;  // streams of ptrace's kind, and of ptaccum's
};

std::string made_by(const Settings& s, std::vector<std::string> words, const std::string& input = "") {
    words[0] = s.tool(words[0]);
    Job job;
    job.input = input;
    job.stages = {{words}};
    const Result r = run(job);
    for (const Ended& e : r.stages)
        if (e.status != 0) {
            std::fprintf(stderr, "no seeds:\n%s", r.describe().c_str());
            std::exit(2);
        }
    return r.out;
}

// What ptrace writes, too: the last frame to come, and what the pixels depend on.
std::string announced(const std::string& stream, const std::string& last, const std::string& fingerprint) {
    Pieces pieces = cut_into_pictures(stream);
    for (Pieces::Piece& piece : pieces.all) {
        const size_t at = piece.bytes.find("\nSEED=");
        if (piece.bytes.find("LASTFRAME=") == std::string::npos) piece.bytes.insert(at, "\nLASTFRAME=" + last);
        if (piece.bytes.find("FINGERPRINT=") == std::string::npos)
            piece.bytes.insert(at, "\nFINGERPRINT=" + fingerprint);
    }
    return pieces.joined();
}

Seeds make_seeds(const Settings& s) {
    const std::string view = "VIEW= -vta -vh 180 -vv 180";
    const std::vector<std::vector<std::string>> makers{
        {"mkstream", "frames", "0", "4", "16", "16", "1", view},
        {"mkstream", "frames", "0", "4", "16", "16", "2", view},
        {"mkstream", "frames", "0", "2", "12", "12", "1", view},
        {"mkstream", "frames", "0", "1", "16", "16", "1", "VIEW= -vth -vh 180 -vv 180"},
        {"mkstream", "frames", "3", "6", "16", "16", "1", view},
        {"mkstream", "frames", "0", "0", "16", "16", "1", view}};
    Seeds seeds;
    for (const auto& words : makers) {
        const std::string frames = announced(made_by(s, words), words[3], "scene" + words[4] + words[6]);
        seeds.frames.push_back(frames);
        if (words[2] == "0") seeds.sums.push_back(made_by(s, {"ptaccum"}, frames));
    }
    return seeds;
}

bool is_close(double a, double b, double scale) { return std::fabs(a - b) <= 1e-6 * scale + 1e-30; }

// What ptaccum wrote against what the frames that went in sum to.
std::string compare_sums(const std::string& in, const std::string& out, bool last_only, std::string& outcome) {
    const ModelStream read = read_stream(in), written = read_stream(out);
    outcome = "status 0, of a kind that the model does not know";
    if (read.end == ModelStream::End::foreign) return "";
    if (read.end == ModelStream::End::cut) return "status 0 for a stream that ends inside a picture";
    if (read.pictures.empty()) return "status 0 for a stream without a picture";
    if (read.ends_early()) return "status 0 for a stream that ends before the frame it announced";
    if (!read.pictures[0].frame || read.pictures[0].frames) return "";  // a merge, or a picture passed on
    const auto sums = sums_of(read.pictures);
    if (!sums) return "status 0 for frames that make no sum";
    if (written.end != ModelStream::End::clean) return "status 0, but its own stream is not whole";
    std::vector<const ModelSum*> wanted;
    for (size_t i = 0; i < sums->size(); ++i)
        if (!last_only || i + 1 == sums->size() || (*sums)[i + 1].first == (*sums)[i + 1].last)
            wanted.push_back(&(*sums)[i]);
    if (written.pictures.size() != wanted.size()) return "status 0, but another number of sums than there should be";
    for (size_t k = 0; k < wanted.size(); ++k) {
        const ModelPicture& p = written.pictures[k];
        if (p.frames != wanted[k]->n || p.rgb.size() != wanted[k]->rgb.size())
            return "status 0, but the sum of other frames";
        for (size_t i = 0; i < p.rgb.size(); ++i) {
            if (!std::isfinite(p.rgb[i])) return "status 0, but a pixel of the sum is not finite";
            if (!is_close(p.rgb[i], wanted[k]->rgb[i], wanted[k]->scale[i]))
                return "status 0, but a pixel has another value";
        }
    }
    outcome = "status 0, the sums are right";
    return "";
}

std::vector<std::string> table_rows(const std::string& text) {
    std::vector<std::string> rows;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) rows.push_back(line);
    if (!rows.empty()) rows.erase(rows.begin());  // the names
    return rows;
}

// A row without its first columns (frame and seconds, or file).
std::string numbers_of(const std::string& row, int skip) {
    size_t at = 0;
    while (skip-- > 0 && at != std::string::npos) at = row.find('\t', at + 1);
    return at == std::string::npos ? "" : row.substr(at);
}

// What vcmetrics says of a stream against what it says of each of its pictures alone.
std::string compare_metrics(const Settings& s, const std::string& in, const std::string& out, const std::string& folder,
                            std::string& outcome) {
    const ModelStream read = read_stream(in);
    outcome = "status 0, of a kind that the model does not know";
    if (read.end == ModelStream::End::foreign) return "";
    if (read.end == ModelStream::End::cut) return "status 0 for a stream that ends inside a picture";
    if (read.ends_early()) return "status 0 for a stream that ends before the frame it announced";
    const auto rows = table_rows(out);
    if (rows.size() != read.pictures.size()) return "status 0, but another number of lines than pictures";
    for (const std::string& row : rows)  // below 0 lux there is no DGP; the negative pixels were warned of
        if (row.find_first_of("ni") != std::string::npos && numbers_of(row, 2).compare(0, 2, "\t-") != 0)
            return "status 0, but a metric is not finite";
    Job alone;
    alone.folder = folder;
    alone.stages = {{{s.tool("vcmetrics")}}};
    for (size_t i = 0; i < read.pictures.size(); ++i) {
        const std::string name = "alone" + std::to_string(i) + ".hdr";
        write_file(folder + "/" + name, write_picture(read.pictures[i]));
        alone.stages[0].words.push_back(name);
    }
    const Result again = run_patiently(alone, s);
    const auto rows_alone = table_rows(again.out);
    if (rows_alone.size() != rows.size())
        return "status 0, but a picture of it is refused by itself: " + again.describe();
    for (size_t i = 0; i < rows.size(); ++i)
        if (numbers_of(rows[i], 2) != numbers_of(rows_alone[i], 1))
            return "status 0, but picture " + std::to_string(i) + " by itself gives other numbers:\n" + rows[i] + "\n" +
                   rows_alone[i];
    outcome = "status 0, the metrics are right";
    return "";
}

Verdict judge(const Settings& s, Dice& dice, const std::string& folder, const Seeds& seeds) {
    const int target = dice.within(0, 2);  // ptaccum, vcmetrics, both
    std::string stream = dice.pick(target == 1 ? seeds.sums : seeds.frames), how;
    const auto& others = dice.chance(.5) ? seeds.frames : seeds.sums;
    for (int i = dice.chance(.7) ? 1 : dice.within(2, 3); i > 0; --i) how += mutate_stream(stream, others, dice) + "; ";
    stream.resize(std::min<size_t>(stream.size(), 900000));
    write_file(folder + "/stream", stream);

    const bool last_only = target == 0 && dice.chance(.3), file = target != 1 && dice.chance(.3);
    Job job;
    job.folder = folder;
    job.input = stream;
    if (target != 1) job.stages.push_back({{s.tool("ptaccum")}});
    if (last_only)
        for (const char* word : {"-last", "-ff"}) job.stages[0].words.push_back(word);
    if (file)
        for (const char* word : {"-o", "sum.exr", "-o", "-"}) job.stages[0].words.push_back(word);
    if (target != 0) job.stages.push_back({{s.tool("vcmetrics")}});
    const Result r = run_patiently(job, s);

    Verdict v;
    const char* names[] = {"ptaccum", "vcmetrics", "ptaccum | vcmetrics"};
    v.story = how + names[target] + " < stream\n" + r.describe();
    v.find = complaint(r);
    const Ended& last = r.stages.back();
    v.outcome = "status " + std::to_string(last.status);
    if (!v.find.empty()) return v;
    for (const std::string& name : files_of(folder))
        if (name != "stream" && name != "sum.exr") v.find = "a file is left: " + name;
    if (last.status == 0 && r.stages[0].status != 0)
        v.find = "vcmetrics is content with the sums of a stream that ptaccum refused";
    if (last.status == 0 && v.find.empty() && target == 0) v.find = compare_sums(stream, r.out, last_only, v.outcome);
    if (last.status == 0 && v.find.empty() && target == 1)
        v.find = compare_metrics(s, stream, r.out, folder, v.outcome);
    v.outcome = std::string(names[target]) + ": " + v.outcome;
    return v;
}

}  // namespace
}  // namespace breaking

int main(int argc, char** argv) {
    using namespace breaking;
    const Settings settings = parse_settings(argc, argv, 300);
    const Seeds seeds = make_seeds(settings);
    return campaign("break_streams", settings,
                    [&](Dice& dice, const std::string& folder) { return judge(settings, dice, folder, seeds); });
}
