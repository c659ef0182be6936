// The program: command line in, files and diagnostics out. Exit status 0: done; 1: the work failed, with the reason on
// standard error; 2: the command line is wrong.
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "back/build_program.h"
#include "emit/emit.h"
#include "emit/list_effect.h"
#include "emit/namespace_name.h"
#include "lower/read_effect.h"

namespace {

enum Status { Done = 0, WorkFailed = 1, WrongCommandLine = 2 };

struct Options {
    std::string effect;
    std::vector<std::string> include_folders;
    std::vector<std::string> defines;  ///< NAME or NAME=VALUE
    std::string folder;
    std::string name_space;
    std::string depfile;
    int jobs = permgen::default_jobs();
    bool freeze = false;
    bool json = false;
};

bool is_identifier(const std::string& text) {
    const auto good = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
           std::all_of(text.begin(), text.end(), good);
}

std::string check_define(const std::string& define) {
    return is_identifier(define.substr(0, define.find('='))) ? "" : "a definition is NAME or NAME=VALUE";
}

std::string check_not_empty(const std::string& path) {
    return path.empty() ? "a path cannot be empty" : "";
}

std::string check_namespace(const std::string& name) {
    return permgen::is_namespace(name) ? "" : "'" + name + "' cannot be a C++ namespace";
}

void add_source_options(CLI::App& command, Options& options) {
    command.add_option("FILE.fx", options.effect, "the effect")->required()->check(CLI::Validator(check_not_empty, ""));
    command.add_option("-I", options.include_folders, "folder to look for included files in; may be given again")
        ->type_name("DIR")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_option("-D", options.defines, "macro to define, with the value 1 unless one is given")
        ->type_name("NAME[=VALUE]")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(CLI::Validator(check_define, ""));
    constexpr int max_jobs = 1024;
    command.add_option("--jobs", options.jobs, "entry points to compile at a time; default: number of processors")
        ->type_name("N")
        ->check(CLI::Range(1, max_jobs));
}

permgen::SourceOptions source_options(const Options& options) {
    permgen::SourceOptions source{options.include_folders, {}};
    for (const std::string& define : options.defines) {
        const std::size_t equals = define.find('=');
        source.defines.emplace_back(define.substr(0, equals),
                                    equals == std::string::npos ? "1" : define.substr(equals + 1));
    }
    return source;
}

std::optional<permgen::Program> build(const Options& options) {
    permgen::Diagnostics diagnostics;
    std::optional<permgen::Program> program;
    permgen::Lowered effect = permgen::read_effect(options.effect, source_options(options), diagnostics);
    if (!permgen::has_errors(diagnostics)) {
        permgen::BuildOptions build_options;
        build_options.jobs = options.jobs;
        program = permgen::build_program(std::move(effect), build_options, diagnostics);
    }
    for (const permgen::Diagnostic& diagnostic : diagnostics)
        std::fprintf(stderr, "%s\n", permgen::format(diagnostic).c_str());
    return program;
}

/// The reason not to write these files: one would replace a file that was read, or another output.
std::string collision(const std::vector<permgen::OutputFile>& files, const std::vector<std::string>& read) {
    std::error_code ignored;  // a file that does not exist yet cannot be another file
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (const std::string& source : read)
            if (std::filesystem::equivalent(files[i].path, source, ignored))
                return "cannot write '" + files[i].path + "': the effect is made of this file; choose another";
        for (std::size_t other = 0; other < i; ++other)
            if (std::filesystem::weakly_canonical(files[i].path, ignored) ==
                std::filesystem::weakly_canonical(files[other].path, ignored))
                return "cannot write '" + files[i].path + "' twice; give --depfile another name";
    }
    return {};
}

Status compile(const Options& options) {
    const auto program = build(options);
    if (!program) return WorkFailed;
    const permgen::EmitOptions emit_options{
        options.name_space.empty() ? permgen::default_namespace(program->effect.name) : options.name_space,
        options.freeze};
    const std::filesystem::path folder = options.folder;
    std::vector<permgen::OutputFile> files = permgen::emit_files(*program, emit_options);
    for (permgen::OutputFile& file : files) file.path = (folder / file.path).string();
    if (!options.depfile.empty())
        files.push_back({options.depfile, permgen::emit_depfile(files.back().path, program->effect.dependencies)});
    std::string why = collision(files, program->effect.dependencies);
    if (why.empty())
        if (const auto written = permgen::write_files(files); !written) why = written.error().message;
    if (!why.empty()) {
        permgen::Diagnostic diagnostic{permgen::Severity::Error, "PG070", {options.effect, 0, 0}, why};
        std::fprintf(stderr, "%s\n", permgen::format(diagnostic).c_str());
        return WorkFailed;
    }
    return Done;
}

Status list(const Options& options) {
    const auto program = build(options);
    if (!program) return WorkFailed;
    const std::string text = options.json ? permgen::list_json(*program) : permgen::list_table(*program);
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
        std::fprintf(stderr, "error[PG071]: the list could not be written to standard output\n");
        return WorkFailed;
    }
    return Done;
}

Status run(int argc, char** argv) {
    CLI::App app("permgen: compiles an effect with switches and techniques to SPIR-V with specialization constants",
                 "permgen");
    app.set_version_flag("--version", std::string("permgen ") + PERMGEN_VERSION);
    app.require_subcommand(1);
    Options options;

    CLI::App* compile_command = app.add_subcommand("compile", "write NAME.fx.h, NAME.fx.json and the .spv files");
    add_source_options(*compile_command, options);
    compile_command->add_option("-o", options.folder, "folder to write to; made if it is missing")
        ->type_name("DIR")
        ->required()
        ->check(CLI::Validator(check_not_empty, ""));
    compile_command->add_option("--namespace", options.name_space, "of the header; default: the effect's name")
        ->type_name("NS")
        ->check(CLI::Validator(check_namespace, ""));
    compile_command->add_flag("--freeze", options.freeze, "write every pass's specialized modules too");
    compile_command->add_option("--depfile", options.depfile, "write the files that were read, in Make's syntax")
        ->type_name("F");

    CLI::App* list_command = app.add_subcommand("list", "list the techniques and what they need");
    add_source_options(*list_command, options);
    list_command->add_flag("--json", options.json, "as JSON");

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? Done : WrongCommandLine;
    }
    return compile_command->parsed() ? compile(options) : list(options);
}

}  // namespace

int main(int argc, char** argv) {
    // Writing past a size limit or into a closed pipe must be reported as an error; by default it ends the process.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "permgen: error[PG099]: %s; this is a fault of permgen, please report it\n", error.what());
        return WorkFailed;
    }
}
