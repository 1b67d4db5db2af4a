//! What a script may touch, and results that are neither lost nor taken for whole.

use super::{MODEL, Place, run};
use std::fs;
use std::os::unix::fs::symlink;
use std::process::{Command, Stdio};

const STATIC: &str = "fix 3 1 1 1\nintegrator LoadControl 1\nalgorithm Linear\nanalysis Static\n";

/// A folder with `inside`, where scripts run, and `outside`.
fn place() -> Place {
    let place = Place::new();
    for folder in ["inside", "outside"] {
        fs::create_dir(place.0.join(folder)).unwrap();
    }
    place.write("outside/kept.txt", "kept");
    place
}

/// Run a script in `inside`.
fn inside(place: &Place, options: &[&str], script: &str) -> (Option<i32>, String) {
    place.write("inside/m.tcl", script);
    let output = Command::new(env!("CARGO_BIN_EXE_hysteron"))
        .arg("run")
        .args(options)
        .arg("m.tcl")
        .current_dir(place.0.join("inside"))
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout) + &text(&output.stderr))
}

#[test]
fn scripts_write_below_the_current_folder_only() {
    let whole = |place: &Place| place.0.join("outside").to_string_lossy().into_owned();
    for command in [
        "set f [open OUT/new.txt w]",
        "set f [open OUT/kept.txt a]",
        "set f [open OUT/kept.txt {RDWR}]",
        "file delete OUT/kept.txt",
        "file delete -force OUT",
        "file rename OUT/kept.txt mine.txt",
        "file rename m.tcl OUT/new.txt",
        "file copy m.tcl OUT/new.txt",
        "file mkdir OUT/deeper",
        "file mtime OUT/kept.txt 0",
        "cd OUT; set f [open new.txt w]",
        "recorder Node -file OUT/new.txt -node 2 -dof 1 disp",
        "recorder Node -file OUT/deeper/new.txt -node 2 -dof 1 disp",
        "figure OUT/f.svg -title t -x x -y y -line l {0 1} {0 1}",
        "print -file OUT/new.txt",
        "set f [open link.txt w]",
        "set f [open nothing.txt w]",
        "set f [open folder/new.txt w]",
    ] {
        for out in ["../outside", "WHOLE"] {
            let place = place();
            symlink(place.0.join("outside/kept.txt"), place.0.join("inside/link.txt")).unwrap();
            symlink(place.0.join("outside/absent.txt"), place.0.join("inside/nothing.txt")).unwrap();
            symlink(place.0.join("outside"), place.0.join("inside/folder")).unwrap();
            let script = format!("{MODEL}{}\n", command.replace("OUT", &out.replace("WHOLE", &whole(&place))));
            let (status, said) = inside(&place, &[], &script);
            assert!(status == Some(2) && said.contains("m.tcl:11:"), "{command}: {status:?} {said}");
            let outside: Vec<_> = fs::read_dir(place.0.join("outside")).unwrap().collect();
            assert!(outside.len() == 1 && fs::read(place.0.join("outside/kept.txt")).unwrap() == b"kept", "{command}");
            if !command.contains("nothing.txt") {
                assert!(said.contains("--allow-write"), "{command}: {said}");
                let (status, said) = inside(&place, &["--allow-write", "../outside"], &script);
                assert_eq!(status, Some(0), "{command}: {said}");
            }
        }
    }
}

#[test]
fn sandbox_reads_below_its_folders_only() {
    let place = place();
    for (command, status) in [
        ("set f [open ../outside/kept.txt]", 2),
        ("source ../outside/kept.txt", 2),
        ("glob ../outside/*", 2),
        ("timeSeries Path 7 -dt 1 -filePath ../outside/kept.txt", 2),
        ("set p $env(PATH)", 2),
        ("set f [open own.txt w]; puts $f 1; close $f; puts [gets [open own.txt]]", 0),
    ] {
        let (found, said) = inside(&place, &["--sandbox"], &format!("{MODEL}{command}\n"));
        assert!(found == Some(status), "{command}: {found:?} {said}");
        assert!(status == 0 || said.contains("m.tcl:11:"), "{command}: {said}");
    }
    let (status, said) = inside(&place, &[], "puts [gets [open ../outside/kept.txt]]\n");
    assert!(status == Some(0) && said == "kept\n", "{said}");
}

/// Links that lie in the folder of the outputs are not followed.
#[test]
fn files_of_the_output_folder_are_made_anew() {
    let place = place();
    fs::create_dir(place.0.join("inside/res")).unwrap();
    fs::create_dir(place.0.join("inside/sub")).unwrap();
    for name in ["d.out", "d.out.part", "e.out", "t.txt"] {
        symlink(place.0.join("outside/kept.txt"), place.0.join("inside/res").join(name)).unwrap();
    }
    let tail = "recorder Node -file d.out -node 2 -dof 1 disp\nrecorder Node -file e.out -closeOnWrite -node 2 -dof 1 disp\n\
        set f [open t.txt w]; puts $f new; close $f\nanalyze 2\n";
    let (status, said) = inside(&place, &["--out", "res"], &format!("{MODEL}{STATIC}{tail}"));
    assert_eq!(status, Some(0), "{said}");
    assert_eq!(fs::read(place.0.join("outside/kept.txt")).unwrap(), b"kept");
    for name in ["d.out", "e.out", "t.txt"] {
        let file = place.0.join("inside/res").join(name);
        assert!(!fs::symlink_metadata(&file).unwrap().file_type().is_symlink() && !fs::read(&file).unwrap().is_empty());
    }
    symlink(place.0.join("outside"), place.0.join("inside/res/sub")).unwrap();
    let (status, said) = inside(&place, &["--out", "res"], "set f [open sub/new.txt w]\n");
    assert!(status == Some(2) && said.contains("is a link to another folder"), "{said}");
    assert_eq!(fs::read_dir(place.0.join("outside")).unwrap().count(), 1);
}

/// Two recorders of one file would lose rows.
#[test]
fn recorders_do_not_share_a_file() {
    let recorder = |dof: u32| format!("recorder Node -file d.out -node 2 -dof {dof} disp\n");
    let (status, _, err) = run(&format!("{MODEL}{STATIC}{}{}analyze 1\n", recorder(1), recorder(2)));
    assert!(status == Some(2) && err.contains("m.tcl:16:21") && err.contains("m.tcl:15:1: the other one"), "{err}");
    // The same command again, and after "remove recorders" or "wipe", is harmless.
    let (status, _, err) = run(&format!("{MODEL}{STATIC}{}{}analyze 1\n", recorder(1), recorder(1)));
    assert!(status == Some(0) && err.contains("its rows are lost"), "{err}");
    let (status, _, err) = run(&format!("{MODEL}{STATIC}{}remove recorders\n{}analyze 1\n", recorder(1), recorder(2)));
    assert!(status == Some(0) && err.is_empty(), "{err}");
}

#[test]
fn full_output_is_an_error() {
    let place = Place::new();
    place.write("m.tcl", format!("{MODEL}puts done\nset f [open end.txt w]; close $f\n"));
    let full = || Stdio::from(fs::OpenOptions::new().write(true).open("/dev/full").unwrap());
    for args in [&["run", "m.tcl"][..], &["check", "m.tcl"], &["commands"]] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
        let output = command.args(args).current_dir(&place.0).stdout(full()).output().unwrap();
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(1) && err.contains("cannot write to standard output"), "{args:?}: {err}");
    }
    assert!(place.0.join("end.txt").exists());
    // Messages that cannot be printed are no panic.
    place.write("bad.tcl", "frobnicate\n");
    let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
    let status = command.args(["run", "bad.tcl"]).current_dir(&place.0).stderr(full()).status().unwrap();
    assert_eq!(status.code(), Some(2));
}

/// Files that another program has planted in the place of results lead nowhere.
#[test]
fn planted_links_are_replaced() {
    let place = place();
    let kept = place.0.join("outside/kept.txt");
    let plant = |name: &str| {
        let path = place.0.join("inside").join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        symlink(&kept, path).unwrap();
    };
    for name in ["p.pvd", "p/000000.vtu", "d.out", ".d.out.part"] {
        plant(name);
    }
    let recorders = "recorder PVD p disp\nrecorder Node -file d.out -node 2 -dof 1 disp\n";
    let (status, said) = inside(&place, &[], &format!("{MODEL}{STATIC}{recorders}analyze 2\n"));
    assert_eq!(status, Some(0), "{said}");
    assert_eq!(fs::read_to_string(place.0.join("inside/p.pvd")).unwrap().matches("DataSet").count(), 2);
    // A folder that leads elsewhere is refused.
    symlink(place.0.join("outside"), place.0.join("inside/q")).unwrap();
    let (status, said) = inside(&place, &[], &format!("{MODEL}{STATIC}recorder PVD q disp\nanalyze 1\n"));
    assert!(status == Some(2) && said.contains("below the current folder only"), "{said}");
    let device = "proc pad {tag i j} { uniaxialMaterial Elastic 91 1e6\nelement elastomericBearingBoucWen $tag $i $j 1000. 10. 0.1 0. \
        2. 2. 0.5 0.5 -P 91 -T 91 -My 91 -Mz 91 -orient 0 0 1 1 0 0 }\n";
    place.write("inside/pad.tcl", device);
    for name in ["out/test.tcl", "out/loops.csv", "out/cycles.csv", "out/loops.svg", "out/force.out"] {
        plant(name);
    }
    let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
    let words = ["bearing", "pad.tcl", "-o", "out", "--strains", "0.1", "--thickness", "1", "-P", "50"];
    let output = command.args(words).current_dir(place.0.join("inside")).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(fs::read(&kept).unwrap(), b"kept");
    assert_eq!(fs::read_dir(place.0.join("outside")).unwrap().count(), 1);
}

/// A backslash is a letter of a name here: what is judged is what is written.
#[test]
fn a_backslash_is_no_folder() {
    let place = place();
    fs::create_dir_all(place.0.join("inside/a")).unwrap();
    symlink(place.0.join("outside/new.txt"), place.0.join("inside/a\\b")).unwrap();
    let (status, said) = inside(&place, &[], "set f [open {a\\b} w]; puts $f x; close $f\n");
    assert!(status == Some(2) && !place.0.join("outside/new.txt").exists(), "{said}");
    let recorder = "recorder Node -file {a\\b} -node 2 -dof 1 disp\n";
    let (status, said) = inside(&place, &[], &format!("{MODEL}{STATIC}{recorder}analyze 2\n"));
    assert_eq!(status, Some(0), "{said}");
    assert!(!place.0.join("outside/new.txt").exists() && !place.0.join("inside/a/b").exists());
    assert_eq!(fs::read_to_string(place.0.join("inside/a\\b")).unwrap().lines().count(), 2);
}

/// The files of checkpoints replace no other files.
#[test]
fn a_script_is_no_journal() {
    for name in ["w.journal", "w.checkpoint"] {
        let place = Place::new();
        let script = format!("{MODEL}{STATIC}analyze 1\n");
        place.write(name, &script);
        let (status, _, err) = place.run(&["run", "--checkpoint", "1s", name]);
        assert!(status == Some(2) && err.contains(&format!("{name} is no file of checkpoints")), "{err}");
        assert_eq!(fs::read_to_string(place.0.join(name)).unwrap(), script);
    }
}
