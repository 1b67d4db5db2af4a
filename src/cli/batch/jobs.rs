//! Jobs of a cluster: the part of a plan that the environment of a job names, and the files of job arrays.

use crate::cli::files::write_atomically;
use clap::ValueEnum;
use std::path::Path;

/// A scheduler, or a launcher of commands.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Scheduler {
    /// Slurm: sbatch
    Slurm,
    /// Lines for PyLauncher
    Pylauncher,
    /// Grid Engine: qsub
    Sge,
    /// PBS Pro: qsub
    Pbs,
}

/// Part of a plan by the environment: that of a Slurm array, or of a task that `srun` has started. A script that `sbatch`
/// runs is one process whatever its number of tasks.
///
/// # Errors
/// The numbers do not fit together.
pub(super) fn scheduled(variable: impl Fn(&str) -> Option<String>) -> Result<Option<(usize, usize)>, String> {
    let number = |name: &str| -> Option<usize> { variable(name)?.trim().parse().ok() };
    if let Some(task) = number("SLURM_ARRAY_TASK_ID") {
        let (first, step) = (number("SLURM_ARRAY_TASK_MIN").unwrap_or(1), number("SLURM_ARRAY_TASK_STEP").unwrap_or(1));
        let count = number("SLURM_ARRAY_TASK_COUNT").unwrap_or(0);
        let index = task.checked_sub(first).map(|past| past / step.max(1) + 1);
        return match index {
            Some(i) if (1..=count).contains(&i) => Ok(Some((i, count))),
            _ => Err(format!("SLURM_ARRAY_TASK_ID is {task} in an array of {count} from {first}: expected --shard")),
        };
    }
    let (Some(_), Some(rank), Some(tasks)) = (number("SLURM_STEP_ID"), number("SLURM_PROCID"), number("SLURM_NTASKS"))
    else {
        return Ok(None);
    };
    Ok((rank < tasks && tasks > 1).then_some((rank + 1, tasks)))
}

/// A word for a shell.
fn quoted(path: &Path) -> String {
    let text = path.to_string_lossy();
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-+".contains(c);
    if text.chars().all(plain) { text.into_owned() } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

/// Write the files of a job array into a folder.
pub(super) fn write_jobs(scheduler: Scheduler, plan: &Path, out: &Path, jobs: u32) -> Result<(), String> {
    let command = |shard: &str| {
        format!("hysteron batch {} --out {} --threads 1 --resume --shard {shard}", quoted(plan), quoted(out))
    };
    let (name, text, submit) = match scheduler {
        Scheduler::Slurm => (
            "batch.slurm",
            format!(
                "#!/bin/bash\n#SBATCH --job-name=hysteron\n#SBATCH --array=1-{jobs}\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n\n{}\n",
                command(&format!("$SLURM_ARRAY_TASK_ID/{jobs}"))
            ),
            "sbatch",
        ),
        Scheduler::Sge => (
            "batch.sge",
            format!(
                "#!/bin/bash\n#$ -N hysteron\n#$ -t 1-{jobs}\n#$ -cwd\n#$ -V\n\n{}\n",
                command(&format!("$SGE_TASK_ID/{jobs}"))
            ),
            "qsub",
        ),
        Scheduler::Pbs => (
            "batch.pbs",
            format!(
                "#!/bin/bash\n#PBS -N hysteron\n#PBS -J 1-{jobs}\n#PBS -l select=1:ncpus=1\n\ncd \"$PBS_O_WORKDIR\"\n{}\n",
                command(&format!("$PBS_ARRAY_INDEX/{jobs}"))
            ),
            "qsub",
        ),
        Scheduler::Pylauncher => {
            let lines: String = (1..=jobs).map(|i| command(&format!("{i}/{jobs}")) + "\n").collect();
            ("commandlines", lines, "pylauncher.ClassicLauncher: ")
        }
    };
    let file = out.join(name);
    write_atomically(&file, &text)?;
    eprintln!("{submit} {}", file.display());
    eprintln!("then: hysteron batch {} --out {} --merge", quoted(plan), quoted(out));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::scheduled;

    fn part(variables: &[(&str, &str)]) -> Result<Option<(usize, usize)>, String> {
        scheduled(|name| variables.iter().find(|(n, _)| *n == name).map(|(_, v)| (*v).to_owned()))
    }

    #[test]
    fn the_environment_names_a_part() {
        let array = |id| {
            let id = ("SLURM_ARRAY_TASK_ID", id);
            [id, ("SLURM_ARRAY_TASK_MIN", "2"), ("SLURM_ARRAY_TASK_STEP", "3"), ("SLURM_ARRAY_TASK_COUNT", "4")]
        };
        assert_eq!(part(&[]), Ok(None));
        assert_eq!(part(&array("2")), Ok(Some((1, 4))));
        assert_eq!(part(&array("11")), Ok(Some((4, 4))));
        assert!(part(&array("14")).is_err() && part(&array("1")).is_err());
        let tasks = [("SLURM_PROCID", "0"), ("SLURM_NTASKS", "4"), ("SLURM_STEP_ID", "0")];
        assert_eq!(part(&tasks), Ok(Some((1, 4))));
        assert_eq!(part(&tasks[..2]), Ok(None), "sbatch runs its script once");
    }
}
