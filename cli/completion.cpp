// SPDX-License-Identifier: MIT
#include "cli/completion.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace hedgehog::cli {

namespace {

/// A verb by its path, "/preview/pulse" ("": the program), and all options accepted there.
struct Place {
  std::string path;
  const Command* command = nullptr;
  std::vector<const CommandOption*> options{};
};

void append_places(std::vector<Place>& places, const Command& command, const std::string& path,
                   std::vector<const CommandOption*> from_above) {
  Place place{path, &command, from_above};
  for (const CommandOption& option : command.options) {
    place.options.push_back(&option);
    if (command.options_behind_verbs && option.names.back() != "--help" &&
        option.names.back() != "--version")
      from_above.push_back(&option);
  }
  places.push_back(std::move(place));
  for (const Command& verb : command.verbs)
    append_places(places, verb, path + "/" + verb.name, from_above);
}

std::vector<Place> places_of(const Command& program) {
  std::vector<Place> places;
  append_places(places, program, "", {});
  return places;
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

/// Single-quoted for bash and zsh.
std::string quoted(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

std::string joined(const std::vector<std::string>& words, std::string_view between = " ") {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

std::string function_name(const Command& program) { return "_" + replaced(program.name, "-", "_"); }

/// Patterns of a shell's `case` that match the paths of verbs.
std::string verb_patterns(const std::vector<Place>& places) {
  std::vector<std::string> paths;
  for (const Place& place : places)
    if (!place.path.empty()) paths.push_back("'" + place.path + "'");
  return joined(paths, "|");
}

std::vector<std::string> words_at(const Place& place) {
  std::vector<std::string> words;
  for (const Command& verb : place.command->verbs) words.push_back(verb.name);
  for (const CommandOption* option : place.options)
    words.insert(words.end(), option->names.begin(), option->names.end());
  return words;
}

/// "'/push --shape'" for each name of an option with a value.
std::vector<std::string> value_patterns(const Place& place, const CommandOption& option) {
  std::vector<std::string> patterns;
  for (const std::string& name : option.names)
    patterns.push_back("'" + place.path + " " + name + "'");
  return patterns;
}

/// The same for all options with a value, separated by `between`.
std::string value_patterns(const std::vector<Place>& places, std::string_view between) {
  std::vector<std::string> all;
  for (const Place& place : places) {
    for (const CommandOption* option : place.options) {
      if (option->value.empty()) continue;
      const std::vector<std::string> patterns = value_patterns(place, *option);
      all.insert(all.end(), patterns.begin(), patterns.end());
    }
  }
  return joined(all, between);
}

/// A line of `case` for each option with a fixed set of values; `offer` makes its command.
template <class Offer>
std::string choice_cases(const std::vector<Place>& places, Offer offer) {
  std::string text;
  for (const Place& place : places)
    for (const CommandOption* option : place.options)
      if (!option->choices.empty())
        text += "    " + joined(value_patterns(place, *option), "|") + ") " +
                offer(joined(option->choices)) + " ;;\n";
  return text;
}

/// The body of a loop of bash and zsh over the words before the current one: `at` becomes the path
/// of the verb, `option` the option whose value is the current word.
std::string walk(const std::vector<Place>& places, const std::string& word) {
  std::string text = "    if [[ -n $option ]]; then option=''; continue; fi\n";
  if (const std::string options = value_patterns(places, "|"); !options.empty())
    text += "    case \"$at " + word + "\" in\n      " + options + ") option=" + word +
            "; continue ;;\n    esac\n";
  if (places.size() > 1)
    text += "    case \"$at/" + word + "\" in\n      " + verb_patterns(places) + ") at=$at/" +
            word + " ;;\n    esac\n";
  return text;
}

}  // namespace

std::string bash_completion(const Command& program) {
  const std::vector<Place> places = places_of(program);
  const std::string name = function_name(program);
  std::string text = "# Completions of " + program.name + " for bash, made by it.\n" + name +
                     "() {\n"
                     "  local at='' option='' i part space rest=$COMP_LINE\n"
                     "  local -a words=()\n"
                     "  # Bash parts words at '=' and ':'. Here a word ends at a space.\n"
                     "  for part in \"${COMP_WORDS[@]:0:COMP_CWORD+1}\"; do\n"
                     "    space=${rest%%[![:space:]]*}\n"
                     "    rest=${rest#\"$space$part\"}\n"
                     "    if [[ -n $space || ${#words[@]} -eq 0 ]]; then\n"
                     "      words+=(\"$part\")\n"
                     "    else\n"
                     "      words[${#words[@]}-1]+=$part\n"
                     "    fi\n"
                     "  done\n"
                     "  local current=${words[${#words[@]}-1]}\n"
                     "  for ((i = 1; i < ${#words[@]} - 1; i++)); do\n" +
                     walk(places, "${words[i]}") +
                     "  done\n"
                     "  if [[ -z $option && $current == --*=* ]]; then\n"
                     "    option=${current%%=*} current=${current#*=}\n"
                     "  fi\n"
                     "  COMPREPLY=()\n"
                     "  case \"$at $option\" in\n"
                     "    *' ') ;;\n";
  text += choice_cases(places, [](const std::string& choices) {
    return "mapfile -t COMPREPLY < <(compgen -W '" + choices + "' -- \"$current\")";
  });
  // Without offered words bash completes file names.
  text +=
      "  esac\n"
      "  [[ -z $option ]] || return\n"
      "  local offered=''\n"
      "  case $at in\n";
  for (const Place& place : places)
    text += "    '" + place.path + "') offered='" + joined(words_at(place)) + "' ;;\n";
  return text +
         "  esac\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$offered\" -- \"$current\")\n"
         "}\n"
         "complete -o default -F " +
         name + " " + program.name + "\n";
}

std::string zsh_completion(const Command& program) {
  const std::vector<Place> places = places_of(program);
  // In zsh's _describe a colon separates a word from its description.
  const auto explained = [](const std::string& word, const std::string& help) {
    return quoted(replaced(word, ":", "\\:") + ":" + replaced(help, "\n", " "));
  };
  std::string text = "#compdef " + program.name + "\n# Completions of " + program.name +
                     " for zsh, made by it.\n"
                     "local at='' option='' word\n"
                     "local -a verbs options\n"
                     "for word in \"${(@)words[2,CURRENT-1]}\"; do\n" +
                     walk(places, "$word") +
                     "done\n"
                     "if [[ -z $option && $words[CURRENT] == --*=* ]]; then\n"
                     "  option=${words[CURRENT]%%=*}\n"
                     "  compset -P '*='\n"
                     "fi\n"
                     "case \"$at $option\" in\n"
                     "    *' ') ;;\n";
  text += choice_cases(
      places, [](const std::string& choices) { return "compadd -- " + choices + "; return"; });
  text += "    *) _files; return ;;\n";
  text += "esac\ncase $at in\n";
  for (const Place& place : places) {
    text += "  '" + place.path + "')\n    verbs=(";
    for (const Command& verb : place.command->verbs)
      text += "\n      " + explained(verb.name, verb.help);
    text += ")\n    options=(";
    for (const CommandOption* option : place.options)
      for (const std::string& name : option->names)
        text += "\n      " + explained(name, option->help);
    text += ") ;;\n";
  }
  return text +
         "esac\n"
         "if [[ $words[CURRENT] == -* ]]; then\n"
         "  _describe -o option options\n"
         "elif (( $#verbs )); then\n"
         "  _describe verb verbs\n"
         "else\n"
         "  _files\n"
         "fi\n";
}

std::string fish_completion(const Command& program) {
  const std::vector<Place> places = places_of(program);
  const std::string at = "__" + replaced(program.name, "-", "_") + "_at";
  // In fish's single quotes a backslash escapes itself and the quote.
  const auto fish_quoted = [](const std::string& words) {
    return "'" + replaced(replaced(replaced(words, "\\", "\\\\"), "'", "\\'"), "\n", " ") + "'";
  };
  const std::string options = value_patterns(places, " ");
  std::string text = "# Completions of " + program.name +
                     " for fish, made by it.\n"
                     "function " +
                     at +
                     "\n"
                     "  set -l at ''\n"
                     "  set -l option ''\n"
                     "  set -l words (commandline -opc)\n"
                     "  for word in $words[2..-1]\n"
                     "    if test -n \"$option\"\n"
                     "      set option ''\n"
                     "      continue\n"
                     "    end\n" +
                     (options.empty() ? ""
                                      : "    switch \"$at $word\"\n      case " + options +
                                            "\n        set option $word\n        continue\n"
                                            "    end\n") +
                     "    switch \"$at/$word\"\n";
  std::vector<std::string> paths;
  for (const Place& place : places)
    if (!place.path.empty()) paths.push_back("'" + place.path + "'");
  if (!paths.empty()) text += "      case " + joined(paths) + "\n        set at \"$at/$word\"\n";
  text += "    end\n  end\n  test \"$at\" = \"$argv[1]\"\nend\n";
  for (const Place& place : places) {
    const std::string here =
        "complete -c " + program.name + " -n '" + at + " \"" + place.path + "\"'";
    for (const Command& verb : place.command->verbs)
      text += here + " -f -a " + verb.name + " -d " + fish_quoted(verb.help) + "\n";
    for (const CommandOption* option : place.options) {
      text += here;
      for (const std::string& name : option->names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option->choices.empty())
        text += " -x -a '" + joined(option->choices) + "'";
      else if (!option->value.empty())
        text += " -r";
      text += " -d " + fish_quoted(option->help) + "\n";
    }
  }
  return text;
}

}  // namespace hedgehog::cli
