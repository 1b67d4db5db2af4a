//! The analysis loop allocates nothing after its first step, and the same input gives the same bits.

#![allow(clippy::unwrap_used, unreachable_pub)]

#[path = "support/script.rs"]
mod script;

use hysteron::analysis::{Engine, Observer, Quiet};
use hysteron::number_format::Style;
use hysteron::record::{Cadence, ElementResponse, Layout, NodeQuantity, NodeResponse, Recorder, RowFile, Separator};
use std::alloc::{self, GlobalAlloc, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

// Safety: passes everything on to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: alloc::Layout) -> *mut u8 {
        COUNT.with(|c| c.set(c.get() + 1));
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, p: *mut u8, layout: alloc::Layout) {
        unsafe { System.dealloc(p, layout) }
    }
    unsafe fn realloc(&self, p: *mut u8, layout: alloc::Layout, size: usize) -> *mut u8 {
        COUNT.with(|c| c.set(c.get() + 1));
        unsafe { System.realloc(p, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// A storey on four bearings with a rigid floor, P-Delta columns, dashpots, Rayleigh damping and member loads.
fn storey(algorithm: &str, integrator: &str, handler: &str) -> String {
    format!(
        "model basic -ndm 3 -ndf 6
        set n 0
        uniaxialMaterial Elastic 1 1.2e6
        uniaxialMaterial Elastic 2 2.0e4
        uniaxialMaterial Viscous 3 20.0 0.7
        uniaxialMaterial Steel01 4 50.0 1e4 0.05
        uniaxialMaterial HDRRheology 5 -compound HDR3 -ambient 0 -area 100 -height 0.1 -heatCapacity 3 -mullins 0.3 0.5
        geomTransf PDelta 1 1 0 0; geomTransf Linear 2 0 0 1
        foreach {{x y}} {{0 0 6 0 6 4 0 4}} {{
            incr n
            node $n $x $y 0; node 1$n $x $y 0; node 2$n $x $y 3
            fix $n 1 1 1 1 1 1
            element elastomericBearingBoucWen $n $n 1$n 7000. 45.0 0.10 0.0 2.0 1.0 0.5 0.5 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
            element KikuchiBearing 4$n $n 1$n -shape round -size 0.5 0.1 -totalHeight 0.2 -nMSS 4 -matMSS 4 -limDisp 0.01 -nMNS 3 -matMNS 1 -orient 0 0 1 1 0 0
            element zeroLength 3$n $n 1$n -mat 3 4 5 -dir 1 2 2
            element elasticBeamColumn 1$n 1$n 2$n 0.1 3e7 1.2e7 0.002 0.001 0.0015 1
            mass 2$n 0 0 10 0 0 0; mass 1$n 5 5 5 0 0 0
        }}
        node 20 3 2 3; fix 20 0 0 1 1 1 0; mass 20 100 100 0 0 0 500
        rigidDiaphragm 3 20 21 22 23 24
        foreach {{e i j}} {{5 21 22 6 22 23 7 23 24 8 24 21}} {{ element elasticBeamColumn $e $i $j 0.08 3e7 1.2e7 0.002 0.001 0.0015 2 -mass 0.2 }}
        timeSeries Linear 1
        pattern Plain 1 1 {{ foreach k {{1 2 3 4}} {{ load 2$k 0 0 -200 0 0 0 }}; eleLoad -ele 5 6 -type -beamUniform 0.0 -3.0 }}
        constraints {handler}; numberer RCM; system UmfPack; test NormDispIncr 1e-9 80; algorithm Newton
        integrator LoadControl 0.1; analysis Static
        analyze 10
        loadConst -time 0.0
        wipeAnalysis
        rayleigh 0.1 0.0 0.001 0.001
        timeSeries Trig 2 0 100 1.1 -factor 3.0
        timeSeries Trig 3 0 100 0.7 -factor 2.0
        pattern UniformExcitation 2 1 -accel 2
        pattern UniformExcitation 3 2 -accel 3
        constraints {handler}; numberer RCM; system UmfPack; test NormDispIncr 1e-7 300; algorithm {algorithm}
        integrator {integrator}; analysis Transient
        analyze 3 0.01"
    )
}

/// A portal of beams of every formulation, with fibers of laws inside others, hinges and shear. It is shaken until the concrete is about to crack.
fn fibre_frame(algorithm: &str) -> String {
    format!(
        "model basic -ndm 2 -ndf 3
        uniaxialMaterial Steel02 1 0.4 200. 0.01 18 0.925 0.15
        uniaxialMaterial Concrete02 2 -0.03 -0.002 -0.006 -0.01 0.1 0.003 2.
        uniaxialMaterial MinMax 3 1 -min -0.2 -max 0.2; uniaxialMaterial Fatigue 4 3
        uniaxialMaterial InitStrainMaterial 5 1 0.0002; uniaxialMaterial Elastic 6 80.; uniaxialMaterial Parallel 7 1 6
        uniaxialMaterial Series 8 1 6
        section Fiber 1 {{
            patch rect 2 10 1 -200 -150 200 150; layer straight 4 3 500 -160 -120 -160 120; layer straight 5 3 500 160 -120 160 120
            layer straight 7 2 300 0 -120 0 120; layer straight 8 2 300 0 -120 0 120
        }}
        section Aggregator 2 6 Vy -section 1
        geomTransf PDelta 1; geomTransf Corotational 2; geomTransf Linear 3
        set k 0
        foreach element {{
            {{forceBeamColumn @ 5 1 1}} {{dispBeamColumn @ 4 1 2}} {{forceBeamColumnCBDI @ 5 1 3}} {{mixedBeamColumn @ 4 1 3}}
            {{AxEqDispBeamColumn2d @ 3 1 1 1e-6 -iter 50}} {{forceBeamColumn @ 10 1 1}} {{forceBeamColumn @ 5 2 1}}
            {{forceBeamColumn @ 1 {{HingeRadau 1 300 1 300 1}}}} {{beamWithHinges @ 1 300 1 300 30. 120000 1.6e9 1}}
        }} {{
            incr k
            node 1$k [expr 5000 * $k] 0; node 2$k [expr 5000 * $k] 3000; fix 1$k 1 1 1; mass 2$k 0.02 0.02 1.
            eval element [string map [list @ \"$k 1$k 2$k\"] $element]
            if {{$k > 1}} {{ element forceBeamColumn 3$k 2[expr $k - 1] 2$k 5 1 3 }}
        }}
        node 30 0 0; node 31 0 0; fix 30 1 1 1; fix 31 1 0 0; mass 31 0 0.02 1.; element zeroLengthSection 30 30 31 1
        timeSeries Trig 1 0 100 0.9 -factor 6000.
        pattern UniformExcitation 1 1 -accel 1
        constraints Transformation; numberer RCM; system UmfPack; test NormDispIncr 1e-4 300; algorithm {algorithm}
        integrator Newmark 0.5 0.25; analysis Transient
        analyze 3 0.01"
    )
}

struct Recording(Vec<Recorder>);

impl Observer for Recording {
    fn committed(&mut self, engine: &mut Engine) -> Result<(), String> {
        self.0.iter_mut().try_for_each(|r| r.record(engine).map(drop)).map_err(|e| e.to_string())
    }
}

fn allocations(engine: &mut Engine, steps: usize, observer: &mut dyn Observer) -> usize {
    engine.analyze(2, 0.01, observer).unwrap();
    let before = COUNT.with(Cell::get);
    engine.analyze(steps, 0.01, observer).unwrap();
    COUNT.with(Cell::get) - before
}

#[test]
fn steps_allocate_nothing() {
    for (algorithm, integrator, handler) in [
        ("Newton", "Newmark 0.5 0.25", "Transformation"),
        ("KrylovNewton", "Newmark 0.5 0.25", "Transformation"),
        ("ModifiedNewton", "HHT 0.9", "Transformation"),
        ("NewtonLineSearch", "Newmark 0.5 0.25", "Penalty 1e9 1e9"),
        ("Newton -initial", "Newmark 0.5 0.25", "Transformation"),
    ] {
        for dense in [Some(false), Some(true)] {
            let mut script = script::Script::default();
            script.options.dense = dense;
            let mut ran = script.run(&storey(algorithm, integrator, handler)).done();
            let count = allocations(&mut ran.interp.host.engine, 40, &mut Quiet);
            assert_eq!(count, 0, "{algorithm}, {integrator}, {handler}, dense {dense:?}");
        }
    }
}

#[test]
fn steps_of_fibre_beams_allocate_nothing() {
    for (compat, algorithm) in [(false, "Newton"), (false, "Newton -initial"), (true, "Newton")] {
        let mut script = script::Script::default();
        script.options.compat = compat;
        let mut ran = script.run(&fibre_frame(algorithm)).done();
        let engine = &mut ran.interp.host.engine;
        let drift = |engine: &Engine| engine.state().disp.iter().fold(0.0f64, |m, u| m.max(u.abs()));
        let count = allocations(engine, 40, &mut Quiet);
        assert_eq!(count, 0, "{algorithm}, compat {compat}");
        let drift = drift(engine);
        assert!(drift > 1.0, "the frame hardly moves: {drift}");
    }
}

#[test]
fn recorders_allocate_nothing() {
    let mut ran = script::run(&storey("Newton", "Newmark 0.5 0.25", "Transformation"));
    let dir = std::env::temp_dir().join(format!("hysteron-allocation-{}", std::process::id()));
    std::fs::create_dir_all(&dir).unwrap();
    let file = |name: &str| {
        Box::new(RowFile::create(&dir.join(name), Layout::Text(Separator::Space), Style::default(), false).unwrap())
    };
    let all = Cadence { time: true, ..Cadence::default() };
    let node = |q: &str| Box::new(NodeResponse::new(NodeQuantity::parse(q).unwrap(), None, vec![0, 1], vec![]));
    let element = |w: &str| Box::new(ElementResponse::new(Some(vec![1, 2]), vec![w.to_owned()], vec![]));
    let mut recorders = Recording(vec![
        Recorder::history(node("disp"), file("disp"), all),
        Recorder::history(node("reaction"), file("reaction"), all),
        Recorder::history(element("localForce"), file("force"), all),
        Recorder::envelope(element("deformation"), file("envelope"), all),
    ]);
    let count = allocations(&mut ran.interp.host.engine, 40, &mut recorders);
    drop(recorders);
    std::fs::remove_dir_all(&dir).unwrap();
    assert_eq!(count, 0);
}

#[test]
fn the_same_input_gives_the_same_bits() {
    let bits = || {
        let mut ran = script::run(&storey("Newton", "Newmark 0.5 0.25", "Transformation"));
        let engine = &mut ran.interp.host.engine;
        engine.analyze(60, 0.01, &mut Quiet).unwrap();
        engine.state().clone()
    };
    let first = bits();
    let threads: Vec<_> = (0..3).map(|_| std::thread::spawn(bits)).collect();
    for t in threads {
        assert_eq!(t.join().unwrap(), first);
    }
}

/// State is data: an engine that is put back goes on to the bit.
#[test]
fn a_state_put_back_goes_on_to_the_bit() {
    let mut script = script::Script::default();
    script.options.dense = Some(false);
    let mut ran = script.run(&storey("Newton", "Newmark 0.5 0.25", "Transformation")).done();
    let engine = &mut ran.interp.host.engine;
    engine.analyze(20, 0.01, &mut Quiet).unwrap();
    let kept = engine.checkpoint();
    engine.analyze(30, 0.01, &mut Quiet).unwrap();
    let end = engine.state().clone();
    engine.restore(&kept);
    engine.analyze(30, 0.01, &mut Quiet).unwrap();
    assert_eq!(*engine.state(), end);
}
