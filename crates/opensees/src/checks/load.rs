//! Checks of the loads, series and records.

hysteron_tcl::checks! {
    EMPTY_SERIES "empty-series":
        "A time series is zero or constant at all times.",
        "It ends before it begins, or has one value or none. Check the times and the file.";
    TIMES_GO_BACK "times-go-back":
        "The times of a series decrease.",
        "Of the points behind an earlier time only the last one before the next time counts, as in OpenSees.";
    TWO_COLUMNS "two-columns" (once):
        "A file of two columns, times and values, is read as one series.",
        "The option -file takes times and values. The command motionFile reads both and the step of time.";
    PARTLY_READ "partly-read":
        "A file is read up to the first word that is no number, as in OpenSees.",
        "Remove the words, or read the file with motionFile, which knows the headers of common formats.";
    RECORDING_NOTE "recording-note":
        "A file of a ground motion has something that its reader must tell.",
        "The message says what was found: gaps, a record of unusual length, a count that differs.";
    NO_ACCELERATIONS "no-accelerations":
        "A file holds velocities or displacements where accelerations are expected.",
        "The option -quantity says that it is meant, and -to converts the series.";
    LAST_WORD_COUNTS "last-word-counts":
        "A pattern has several words behind its options.",
        "The last word holds the loads, as in OpenSees. What stands before it is ignored.";
    RECORD_IN_G "record-in-g" (once):
        "The accelerations of a record are in g, and no factor makes them those of the model.",
        "Give the series or the pattern the factor g in the units of the model.";
    RECORD_TOO_STRONG "record-too-strong" (once):
        "A record is stronger than any that was recorded.",
        "Check the factor of the series and the units of the file.";
    RECORD_IS_OVER "record-is-over" (once):
        "A record ends before the analysis that it excites begins.",
        "The command \"loadConst -time 0.0\" after the gravity loads sets the time back.";
    NO_MASS "no-mass" (once):
        "A pattern moves the ground along a direction in which the model has no mass.",
        "The excitation has no effect. The command \"mass\" or a density gives the model one.";
    LATE_WITHOUT_MOTION "late-without-motion" (once):
        "A support is late, and no uniform excitation moves the model.",
        "The delay has no effect. It counts under \"pattern UniformExcitation\".";
    COARSE_STEPS "coarse-steps" (once):
        "The steps of an analysis are several times as long as those of the record.",
        "Most of the record is passed over. Take steps not longer than those of the record.";
    GROWING_PATTERN "growing-pattern" (once):
        "Loads of a static analysis go on growing in the transient analysis after it.",
        "The command \"loadConst -time 0.0\" holds them.";
}
