# SPDX-License-Identifier: MIT
# mutants.awk FILE: the mutants of a C++ source, a line each, fields by tabs:
#   line, offset of the first character that is replaced (from 0), how many are, what stands there instead,
#   the mutation's name, the text of the line, the text of the line before
# Works on tokens and leans on clang-format: an operator between blanks has two operands, a bracket or a sign without one
# belongs to its neighbour. What it takes for code and is none does not compile, which costs a second and no more.

function blank(at,   c) {
  c = substr(text, at, 1)
  return c == " " || c == "\n" || c == "\t" || c == ""
}

function add(kind, at) {
  ++n
  is[n] = kind
  start[n] = at
  row[n] = line
  spaced[n] = blank(at - 1)
}

# Comments, literals of text and the preprocessor's lines make no tokens that are mutated.
function tokenize(   at, c, two, end, directive) {
  at = 1
  line = 1
  while (at <= size) {
    c = substr(text, at, 1)
    two = substr(text, at, 2)
    if (c == "\n") { ++line; ++at; directive = 0; continue }
    if (c == " " || c == "\t") { ++at; continue }
    if (two == "//" || c == "#") {
      while (at <= size && substr(text, at, 1) != "\n") ++at
      continue
    }
    if (two == "/*") {
      end = index(substr(text, at), "*/")
      for (end += at + 1; at < end; ++at) if (substr(text, at, 1) == "\n") ++line
      continue
    }
    if (c == "\"" || c == "'") {
      add("text", at)
      for (++at; substr(text, at, 1) != c; ++at) if (substr(text, at, 1) == "\\") ++at
      ++at
    } else if (match(substr(text, at, 80), /^[0-9][0-9A-Za-z_.']*/)) {
      add("number", at)
      at += RLENGTH
      if (two != "0x" && substr(text, at - 1, 1) ~ /[eE]/ && substr(text, at, 1) ~ /[-+]/) {
        match(substr(text, at + 1, 80), /^[0-9]*/)
        at += 1 + RLENGTH
      }
    } else if (match(substr(text, at, 80), /^[A-Za-z_][A-Za-z0-9_]*/)) {
      add("name", at)
      at += RLENGTH
    } else {
      add("sign", at)
      if (substr(text, at, 3) ~ /^(<<=|>>=|<=>|\.\.\.)$/) at += 3
      else if (two ~ /^(::|->|\+\+|--|<=|>=|==|!=|&&|\|\||\+=|-=|\*=|\/=|%=|&=|\|=|\^=|<<)$/ || (two == ">>" && spaced[n])) at += 2
      else ++at
    }
    word[n] = substr(text, start[n], at - start[n])
    tight[n] = !blank(at)  # without a blank behind it
  }
}

# mutate FIRST LAST REPLACEMENT NAME: of these tokens.
function mutate(first, last, put, name,   key, from, to) {
  from = start[first]
  to = start[last] + length(word[last])
  key = row[first] SUBSEP name
  if (++seen[key] > 1) name = name " (" seen[key] ")"
  printf "%d\t%d\t%d\t%s\t%s\t%s\t%s\n", row[first], from - 1, to - from, put, name, lines[row[first]], lines[row[first] - 1]
}

function swap(i, put) { mutate(i, i, put, word[i] " to " put) }

function binary(i) { return spaced[i] && !tight[i] }
function operand_ends(i) { return is[i] == "number" || (is[i] == "name" && word[i] !~ /^(return|case|else)$/) || word[i] ~ /^[])]$/ }

# The token that closes what token i opens.
function closing(i,   depth) {
  for (; i <= n; ++i) {
    if (word[i] ~ /^[({[]$/) ++depth
    if (word[i] ~ /^[])}]$/ && --depth == 0) return i
  }
  return n
}

function mutate_operator(i,   w) {
  w = word[i]
  if (binary(i)) {
    if (w in boundary) { swap(i, boundary[w]); swap(i, opposite[w]) }
    else if (w in other) swap(i, other[w])
  } else if (w == "-" && tight[i] && !operand_ends(i - 1)) mutate(i, i, " ", "unary - dropped")
  else if (w == "!" && tight[i]) mutate(i, i, " ", "! dropped")
  else if (w == "++") swap(i, "--")
  else if (w == "--") swap(i, "++")
}

function mutate_number(i,   w) {
  w = word[i]
  if (w ~ /^0(\.0)?[uU]?$/) swap(i, "1")
  else if (w ~ /^1[uU]?$/) { swap(i, "0"); swap(i, "2") }
  else if (w ~ /^0x/ || w !~ /[.eE]/) { swap(i, "0"); mutate(i, i, "(" w " + 1)", w " to " w " + 1") }
  else { swap(i, "0.0"); mutate(i, i, "(2 * " w ")", w " doubled") }
}

function mutate_name(i,   w) {
  w = word[i]
  if (w in other && !(word[i + 1] == "(" && word[i - 1] != "::")) swap(i, other[w])
}

# A condition that is a name, or a call: no operator in it makes it false.
function negate(first, last,   i) {
  for (i = first; i <= last; ++i) if (word[i] in boundary || word[i] in equality || word[i] ~ /^(&&|\|\||!|;|=)$/) return
  if (first <= last) mutate(first, last, "!(" substr(text, start[first], start[last] + length(word[last]) - start[first]) ")", "negated")
}

function negate_before(i,   first, depth) {
  for (first = i - 1; first > 0; --first) {
    if (word[first] ~ /^[])}]$/) ++depth
    if (word[first] ~ /^[({[]$/ && --depth < 0) break
    if (depth <= 0 && word[first] ~ /^(=|,|;|\?|:|return|[-+*\/|&]=?|<<)$/) break
  }
  if (row[first + 1] == row[i - 1]) negate(first + 1, i - 1)
}

# Type, then a name.
function declares(i) {
  if (word[i] ~ /^(const|constexpr|static|auto|using|typedef|struct|class|enum|static_assert|assert|namespace|template|friend|public|private|inline|extern|explicit|case|default|goto|union|virtual)$/) return 1
  if (is[i] != "name" || word[i] == "return") return 0
  while (word[i + 1] == "::") i += 2
  if (word[i + 1] == "<" && !spaced[i + 1]) {
    for (++i; i < n && !(word[i] == ">" && !spaced[i]); ++i);
  }
  while (word[i + 1] ~ /^[*&]$/ && !spaced[i + 1]) ++i
  return is[i + 1] == "name" && word[i + 1] !~ /^(and|or)$/
}

# drop FIRST END FINAL: the statement before END, with FINAL the last of its function.
function drop(first, end, final) {
  if (first >= end || declares(first) || word[first] ~ /^[{}]$/) return
  if (word[first] ~ /^(if|for|while|do|else|switch|try)$/) return
  # What has a value to return must.
  if (final && word[first] == "return") return
  mutate(first, end - 1, " ", "dropped")
}

# One kind of container a brace: "code", "function" (code whose end ends a function), "list" (values), "scope" (class, namespace).
function walk(   i, depth, begin, controlled, top, resume, paren, kind) {
  top = 0
  held[0] = "scope"
  begin = 1
  depth = 0
  for (i = 1; i <= n; ++i) {
    if (word[i] == "(" || word[i] == "[") { ++depth; continue }
    if (word[i] == ")" || word[i] == "]") {
      --depth
      if (word[i] == ")" && i == control_end) { begin = i + 1; controlled = 1; control_end = 0 }
      continue
    }
    if (word[i] == "{") {
      if (word[i - 1] ~ /^(\)|noexcept|const|override|else|do|try)$/ || (held[top] ~ /^(code|function)$/ && i == begin) ||
          (word[i - 1] == "}" && held[top] == "scope" && word[begin] !~ /^(namespace|struct|class|enum)$/)) {
        kind = held[top] == "scope" || depth > 0 || begin < i && word[begin] !~ /^(if|for|while|do|else|switch|try|case|default)$/ && !controlled ? "function" : "code"
      } else if (held[top] == "scope" && word[begin] ~ /^(namespace|struct|class|enum|union|template)$/) kind = "scope"
      else kind = "list"
      ++top
      held[top] = kind
      # After a list, and after a lambda, the statement goes on.
      resume[top] = kind == "list" || (kind == "function" && held[top - 1] != "scope") ? begin : 0
      outside[top] = depth
      depth = 0
      if (kind != "list") { begin = i + 1; controlled = 0 }
      continue
    }
    if (word[i] == "}") {
      depth = outside[top]
      begin = resume[top] ? resume[top] : i + 1
      if (!resume[top]) controlled = 0
      --top
      continue
    }
    if (held[top] !~ /^(code|function)$/) {
      if (word[i] == ";" && depth == 0) begin = i + 1
      continue
    }
    if (i == begin && word[i] ~ /^(if|for|while|switch)$/) {
      paren = word[i + 1] == "constexpr" ? i + 2 : i + 1
      control_end = closing(paren)
      if (word[i] ~ /^(if|while)$/) negate(paren + 1, control_end - 1)
    } else if (i == begin && word[i] ~ /^(else|do)$/) { begin = i + 1; controlled = 1 }
    else if (word[i] == ":" && depth == 0 && word[begin] ~ /^(case|default)$/) { begin = i + 1; controlled = 1 }
    else if (word[i] == ";" && depth == 0) {
      drop(begin, i, held[top] == "function" && word[i + 1] == "}" && !controlled)
      begin = i + 1
      controlled = 0
    }
  }
}

# Tokens of which a mutant would say nothing: of a static_assert, of an assert, of the name of an operator.
function mutate_tokens(   i) {
  for (i = 1; i <= n; ++i) {
    if (word[i] ~ /^(static_assert|assert)$/) { i = closing(i + 1); continue }
    if (word[i] == "operator") { ++i; continue }
    if (word[i] == "?") negate_before(i)
    if (is[i] == "sign") mutate_operator(i)
    else if (is[i] == "number") mutate_number(i)
    else if (is[i] == "name") mutate_name(i)
  }
}

BEGIN {
  split("< <= > >= <= < >= >", pairs, " ")
  for (k = 1; k < 8; k += 2) boundary[pairs[k]] = pairs[k + 1]
  split("< >= >= < > <= <= >", pairs, " ")
  for (k = 1; k < 8; k += 2) opposite[pairs[k]] = pairs[k + 1]
  equality["=="] = equality["!="] = 1
  split("== != && || + - * / << >> & | += -= *= /= &= |= min max true false fmin fmax", pairs, " ")
  for (k = 1; k in pairs; k += 2) { other[pairs[k]] = pairs[k + 1]; other[pairs[k + 1]] = pairs[k] }
  other["%"] = "*"
}

{
  text = text $0 "\n"
  lines[NR] = $0
  sub(/^[ \t]+/, "", lines[NR])
}

END {
  size = length(text)
  tokenize()
  mutate_tokens()
  walk()
}
