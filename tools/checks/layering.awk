# Reports wrong includes of the files named as arguments. Variables: host, the folder of the modules
# with its closing slash; modules and libraries, the tables of tools/checks/layering.

# Splits lines `KEY: VALUE VALUE` into keys[1..] and allowed[key]; returns how many there are.
function read_table(text, keys, allowed,    lines, count, i, colon, size) {
  count = split(text, lines, "\n")
  for (i = 1; i <= count; ++i) {
    colon = match(lines[i], /:( |$)/)
    if (!colon) continue
    keys[++size] = substr(lines[i], 1, colon - 1)
    allowed[keys[size]] = " " substr(lines[i], colon + 1) " "
  }
  return size
}

function contains(list, word) { return index(list, " " word " ") > 0 }

function first_folder(path) { return path ~ "/" ? substr(path, 1, index(path, "/") - 1) : "" }

function complain(what) {
  printf "%s:%d: %s\n", FILENAME, FNR, what
  ++problems
}

function check_module(target, path) {
  if (target != module && (target in module_allows) && !contains(module_allows[module], target))
    complain(module " must not include " target ": " path)
}

function check_libraries(path,    i, library) {
  for (i = 1; i <= library_count; ++i) {
    library = library_names[i]
    if (path ~ library && !contains(library_allows[library], module))
      complain(module " must not include " path ", only these may:" library_allows[library])
  }
}

BEGIN {
  read_table(modules, module_names, module_allows)
  library_count = read_table(libraries, library_names, library_allows)
}

FNR == 1 {
  module = first_folder(substr(FILENAME, length(host) + 1))
  if (!(module in module_allows)) complain("this folder is not in the table of tools/checks/layering")
}

/^[ \t]*#[ \t]*include[ \t]*["<]/ {
  path = $0
  sub(/^[^"<]*["<]/, "", path)
  sub(/[">].*/, "", path)
  if (path ~ /(^|\/)[.][.]?\//) complain("write MODULE/FILE, not the relative path " path)
  check_module(first_folder(path), path)
  check_libraries(path)
}

END { exit problems > 0 }
