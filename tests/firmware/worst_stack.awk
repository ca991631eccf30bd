# SPDX-License-Identifier: MIT
# The deepest chain of calls, from gcc's -fcallgraph-info=su files (.ci), for each function in `roots`.
# Assumes no recursion and no calls through pointers, and reports either. Functions of the compiler's runtime
# have no entry there: `runtime` bytes are counted for each. With `most`, a deeper chain is an error.
/^node:/ {
  split($0, part, "\"")
  name = part[2]
  # Other files only declare the function.
  if (match(part[4], /[0-9]+ bytes/)) { own[name] = substr(part[4], RSTART) + 0; label[name] = part[4] }
  else if (!(name in own)) { own[name] = runtime; label[name] = part[4] }
  if (part[4] ~ /dynamic/ && part[4] !~ /static/) trouble = trouble " dynamic stack in " name ";"
}
/^edge:/ {
  split($0, part, "\"")
  calls[part[2]] = calls[part[2]] "\n" part[4]
  if (part[4] ~ /__indirect_call/) trouble = trouble " call through a pointer in " part[2] ";"
}
function deepest(name, busy,   list, n, i, worst, depth) {
  if (name in known) return known[name]
  if (index(busy, "|" name "|")) { trouble = trouble " recursion at " name ";"; return 0 }
  worst = 0
  n = split(calls[name], list, "\n")
  for (i = 2; i <= n; i++) {
    depth = deepest(list[i], busy "|" name "|")
    if (depth > worst) { worst = depth; via[name] = list[i] }
  }
  return known[name] = own[name] + worst
}
function short(name,   text) {
  text = label[name]
  sub(/\\n.*/, "", text)
  sub(/^[a-z0-9_]+ /, "", text)
  return text
}
END {
  n = split(roots, wanted, " ")
  for (r = 1; r <= n; r++) {
    found = 0
    for (name in own) {
      if (index(name, wanted[r]) == 0 || own[name] == runtime && !(name in calls)) continue
      found = 1
      printf "worst stack %4d bytes: ", deepest(name, "")
      for (at = name; at != ""; at = via[at]) printf "%s%s (%d)", at == name ? "" : " > ", short(at), own[at]
      printf "\n"
      if (most && deepest(name, "") > most) trouble = trouble " more than " most " bytes;"
    }
    if (!found) trouble = trouble " no function " wanted[r] ";"
  }
  if (trouble) { print "worst stack:" trouble; exit 1 }
}
