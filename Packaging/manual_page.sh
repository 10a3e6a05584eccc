#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Packaging/manual_page.sh CARVE PAGE.gz
#
# Writes the help of the program as a manual page. Lines without indent are headings, and lines with four spaces before
# an option name what the lines with eight spaces below them explain.
set -euo pipefail
version=$("$1" --version)
{
  printf '.TH CARVE 1 "" "%s" "User Commands"\n' "$version"
  "$1" --help | sed -e 's/\\/\\e/g' -e 's/-/\\-/g' | awk '
    function line(text) { print (text ~ /^[.\047]/ ? "\\&" : "") text }
    /^[A-Z]/ { print ".SH " $0; plain = /^(SYNOPSIS|EXAMPLES|EXIT)/; if (plain) print ".nf"; next }
    plain { line($0); next }
    /^$/ { print ".PP"; option = 0; next }
    /^    (\\-|[A-Z_]+$)/ { print (option ? ".TQ" : ".TP") "\n\\fB" substr($0, 5) "\\fR"; option = 1; next }
    /^         / { print ".nf"; line(substr($0, 9)); print ".fi"; next }
    { option = 0; sub(/^ +/, ""); line($0) }'
} | gzip -9n >"$2"
