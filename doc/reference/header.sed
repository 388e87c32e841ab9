# The comment at the top of a header says what the file is for; what it indents is a table.
1,/^#pragma once/ {
  s|^//|///|
  s|^///   +|///     |
  s|^#pragma once|/// @file|
}
# These dots end no sentence.
/\/\/\// s/\<(eqs?|Fig|Prop|Sec)\. /\1.\\ /g
