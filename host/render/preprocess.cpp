#include "render/preprocess.h"

#include "base/file.h"
#include "base/text.h"
#include "render/directive.h"

#include <algorithm>

namespace dioptre
{
namespace
{

class Preprocessor
{
public:
    explicit Preprocessor(const PreprocessInput& input) : input_(input), features_(input.features) {}

    void take(const SourceText& source)
    {
        const auto depth = conditions_.size();
        for (const auto& line : source)
            takeLine(line);
        if (conditions_.size() != depth)
            fail(ExitCode::badInput, conditions_.back().where, "this conditional has no #endif",
                 "close it in the same file");
    }

    SourceText result() &&
    {
        return std::move(result_);
    }

private:
    struct Condition {
        bool ours;  // on a HAS_ name: resolved here
        bool taken; // this branch is in the text
        SourcePosition where;
    };

    void takeLine(const SourceLine& line)
    {
        const auto directive = directiveOf(line.text);
        const int column = directive ? static_cast<int>(line.text.find('#')) + 1 : 0;
        const SourcePosition where{line.file, line.line, column};
        if (directive &&
            (directive->name == "ifdef" || directive->name == "ifndef" || directive->name == "if")) {
            open(*directive, where, line);
        } else if (directive && (directive->name == "else" || directive->name == "endif")) {
            turn(*directive, where, line);
        } else if (!emitting()) {
            return;
        } else if (directive && directive->name == "include") {
            include(*directive, where);
        } else {
            if (directive && directive->name == "define" && directive->argument.starts_with("HAS_"))
                features_.insert(
                    std::string(directive->argument.substr(0, directive->argument.find_first_of(" \t("))));
            result_.push_back(line);
        }
    }

    void open(const Directive& directive, const SourcePosition& where, const SourceLine& line)
    {
        const bool ours = directive.argument.starts_with("HAS_") && directive.name != "if";
        const bool present = features_.contains(std::string(directive.argument));
        if (!ours && emitting())
            result_.push_back(line);
        conditions_.push_back({ours, !ours || present == (directive.name == "ifdef"), where});
        notTaken_ += conditions_.back().taken ? 0 : 1;
    }

    void turn(const Directive& directive, const SourcePosition& where, const SourceLine& line)
    {
        if (conditions_.empty())
            fail(ExitCode::badInput, where, "#" + std::string(directive.name) + " without #if", "remove it");
        auto& condition = conditions_.back();
        const bool ours = condition.ours;
        notTaken_ -= condition.taken ? 0 : 1;
        if (directive.name == "endif") {
            conditions_.pop_back();
        } else {
            condition.taken = condition.taken != ours;
            notTaken_ += condition.taken ? 0 : 1;
        }
        if (!ours && emitting())
            result_.push_back(line);
    }

    bool emitting() const
    {
        return notTaken_ == 0;
    }

    void include(const Directive& directive, const SourcePosition& where)
    {
        const auto named = includedName(directive);
        if (!named)
            fail(ExitCode::badInput, where, "#include wants a name in quotes",
                 "write #include \"kernel/sphere.glsl\"");
        const std::string& name = *named;
        if (std::find(open_.begin(), open_.end(), name) != open_.end())
            fail(ExitCode::badInput, where, "\"" + name + "\" includes itself", "break the circle");
        if (!included_.insert(name).second)
            return;
        open_.push_back(name);
        take(contentOf(name, where));
        open_.pop_back();
    }

    SourceText contentOf(const std::string& name, const SourcePosition& where) const
    {
        if (const auto written = input_.generated.find(name); written != input_.generated.end())
            return written->second;
        const auto found = lookFor(name, input_.search, where);
        if (!found.empty())
            return readSource(found);
        std::vector<std::string> folders;
        for (const auto& folder : input_.search.folders)
            folders.push_back(folder.string());
        fail(ExitCode::inputMissing, where, "\"" + name + "\" is not in " + join(folders, " or "),
             "correct the name; it is relative to that folder");
    }

    const PreprocessInput& input_;
    std::set<std::string> features_; // given, and defined in the text so far
    SourceText result_;
    std::vector<Condition> conditions_;
    int notTaken_ = 0;              // of them
    std::vector<std::string> open_; // includes that are being read, for cycles
    std::set<std::string> included_;
};

} // namespace

SourceText preprocess(const SourceText& source, const PreprocessInput& input)
{
    Preprocessor preprocessor(input);
    preprocessor.take(source);
    return std::move(preprocessor).result();
}

} // namespace dioptre
