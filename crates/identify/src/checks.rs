//! Checks of studies: what their messages have in common, and what their codes mean.

hysteron_tcl::checks! {
    FEW_SAMPLES "few-samples":
        "Fewer than three samples are fitted for each free parameter.",
        "A fit of so few proves nothing. Observe more channels, or fix parameters.";
    NO_HOLDOUT "no-holdout":
        "No run of a study is held out.",
        "Nothing judges the fit. Give a run the role \"holdout\".";
    OUTSIDE_BOUNDS "outside-bounds":
        "The value of a parameter in the script lies outside of its bounds in the study.",
        "The search starts from the nearer bound. Correct the value or the bounds.";
    NO_EFFECT "no-effect":
        "No observed channel depends on a parameter within its bounds.",
        "It cannot be found. Fix its value, or observe a channel that depends on it.";
    MISSING_SAMPLES "missing-samples":
        "A recorded channel has cells without a number.",
        "They are left out of the comparison. The message counts them.";
    UNREAD_VARIABLE "unread-variable":
        "A study sets a variable that its script never reads.",
        "It changes nothing. Correct its name, or remove it.";
    TIME_COLUMN "time-column":
        "A channel is compared with the column of an output that holds the time.",
        "Columns count from 0. With -time the first value of a recorder is column 1.";
    CHANNEL_DOUBT "channel-doubt":
        "A recorded channel contradicts the model or another channel before anything is fitted.",
        "The message names unit, sign, delay or level. Correct the study where the finding is right.";
}
