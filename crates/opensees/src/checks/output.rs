//! Checks of the recorders and queries.

hysteron_tcl::checks! {
    NO_FILE "no-file":
        "A recorder names no file, so that nothing is kept.",
        "Give it the option -file.";
    NOTHING_RECORDED "nothing-recorded":
        "A recorder names a range of tags in which nothing is defined.",
        "Define nodes and elements before the recorder.";
    NOT_IN_MODEL "not-in-model":
        "A recorder or a region names nodes, elements or responses that the model does not have.",
        "They are left out, or their column is zero as in OpenSees. The message lists them.";
    SHARED_FILE "shared-file":
        "Two recorders write one file.",
        "The rows of one of them are lost. Give each a file of its own.";
    FOLDER_MADE "folder-made":
        "A recorder writes to a folder that does not exist; it is made.",
        "OpenSees would keep nothing. The command \"file mkdir\" makes the folder beforehand.";
    NOT_WRITTEN "not-written":
        "A recorder for the viewer of another program is passed over.",
        "The script goes on without its file. PVD writes the model for ParaView.";
    NOTHING_REMOVED "nothing-removed":
        "A criterion of collapse has no value, and removes nothing, as in OpenSees.",
        "Give the criterion another name, or remove the word.";
    ALL_VALUES "all-values":
        "A query names the degree of freedom 0, and gives all values, as in OpenSees.",
        "Degrees of freedom count from 1.";
    NO_RESPONSE "no-response":
        "A query asks an element for something that its kind does not have, such as the sections of a spring.",
        "The help lists the responses that the element has. In Python the answer is empty, as in openseespy, with a warning.";
    NOTHING_COMPARED "nothing-compared":
        "The command verify has no tolerance, and compares nothing.",
        "Write the tolerance before the text.";
    JOURNAL_FULL "journal-full":
        "A run is longer than the journal from which a checkpoint goes on.",
        "The run goes on, and writes no checkpoint from there on.";
}
