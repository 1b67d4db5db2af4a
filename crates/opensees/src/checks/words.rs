//! Checks of the words of commands.

hysteron_tcl::checks! {
    MISSING_WORD "missing-word":
        "A command lacks a word that it needs.",
        "The label says which word is expected. Where a usual value stands in its place, the message says so.";
    NOT_A_NUMBER "not-a-number":
        "A word that must be a number is none.",
        "The label says which number was expected. A letter O for a zero and a comma for a point are shown where \
         they are found.";
    OUT_OF_RANGE "out-of-range":
        "A number lies outside of the range in which it has a meaning.",
        "The label says the range. Where OpenSees computes with such a number, \"--compat opensees\" does too, and \
         warns.";
    NO_FLAG "no-flag":
        "A flag is neither 0 nor 1.",
        "The message says what it counts as, which is OpenSees' answer. Another number often stands in a wrong place.";
    NOT_DEFINED "not-defined":
        "A command names a thing that no command before it has defined.",
        "The label lists the tags that are defined. Define the thing first, or correct the tag.";
    TAG_IN_USE "tag-in-use":
        "A tag is given to a thing although another one of its kind has it.",
        "Take a new tag. In a loop the tag must change with the counter; \"wipe\" forgets the model of before.";
    UNREADABLE_FILE "unreadable-file":
        "A file that a command reads is not there, or may not be read.",
        "A path without a leading slash begins in the current folder of the program, as in OpenSees, not in that of the script.";
    UNKNOWN_KIND "unknown-kind":
        "A command asks for a kind or a name that is not known.",
        "The nearest known name is shown. \"hysteron commands\" with the name of the command lists all kinds.";
    NO_MODEL "no-model":
        "A command needs a model, and no model has been begun.",
        "The command \"model basic -ndm 3 -ndf 6\" begins one. It stands before nodes, materials and elements.";
    UNKNOWN_OPTION "unknown-option":
        "A word is no option of the command, and is ignored as in OpenSees.",
        "Correct the word, or remove it. The nearest known option is shown. Numbers behind it are ignored with it.";
    COMMENT_IN_COMMAND "comment-in-command":
        "A comment stands behind a command without a semicolon, so that its words belong to the command.",
        "A comment after a command begins with \";#\".";
    WORDS_LEFT_OVER "words-left-over":
        "Words stand where the command needs none, and are ignored as in OpenSees.",
        "Remove them. A number too many often means that another one is missing before it.";
    UNUSED_WORD "unused-word":
        "OpenSees takes a word and does not use it.",
        "The answer is the same without it. The message says what holds in its place.";
    OVERRIDDEN "overridden":
        "Two words of a command exclude each other, and one of them counts.",
        "Keep the one that is meant. The message says which one counts.";
    REPLACED_VALUE "replaced-value":
        "A value outside of its range is replaced by the nearest one that has a meaning, as in OpenSees.",
        "Write the value that is meant: another program may replace it in another way.";
    DECLARED_TWICE "declared-twice":
        "A parameter of a study is declared twice with different values.",
        "A study gives both places one value. Use one name for each value.";
}
