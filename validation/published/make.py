"""Makes the blind cases. Python 3.11 with numpy 2.4, scipy, numba 0.68, openseespy 3.7.1 (venv: pip install numpy scipy numba openseespy); fixed seeds.
   python make.py [name ...]"""
import os, sys, json, time, hashlib, tempfile, shutil
import numpy as np
from scipy.optimize import least_squares
from scipy import signal
from laws import *
ROOT = os.path.dirname(os.path.abspath(__file__))
GM = os.environ['GROUND_MOTIONS'] + '/'         # a folder with the records of the README as time_s,acc_g CSV
OFF = {}

class R:   # a run
    def __init__(s, name, role, motion, dt, rdt, sub=1, **extra):
        s.name, s.role, s.dt, s.rdt, s.sub = name, role, dt, rdt, sub
        s.motion = motion          # dict suffix -> array
        s.n = len(next(iter(motion.values()))); s.extra = extra
        s.noise = {}
    def sets(s):
        d = {}
        for k in s.motion: d['motion'+k] = s.name+('-'+k if k else '')+'.dat'
        d['dt'] = s.dt; d['npts'] = s.n
        if s.sub > 1: d['nsub'] = s.sub
        d.update({k: v for k, v in s.extra.items() if not k.startswith('_')})
        return d
    def fine(s):
        """inputs on the grid dt/sub, as the Path series interpolates them"""
        tc = np.arange(s.n)*s.dt; tf = np.arange((s.n-1)*s.sub+1)*s.dt/s.sub
        return np.column_stack([np.interp(tf, tc, s.motion[k]) for k in s.motion]), tf

def gm(name, peak, T, t0=0.0, dt=0.01, hp=0.0):
    d = np.loadtxt(GM+name+'.csv', delimiter=',', skiprows=1)
    t = np.arange(int(round(T/dt))+1)*dt
    a = np.interp(t+t0, d[:, 0], d[:, 1], right=0.0)
    if hp: a = signal.sosfiltfilt(signal.butter(2, hp, 'high', fs=1/dt, output='sos'), a)
    w = np.minimum(1, np.minimum(t/0.3, (T-t)/1.0)); a = a*np.clip(w, 0, 1)
    return a*peak/np.abs(a).max()

def cycles(dt, blocks, shape='sin', lead=0.0):
    """blocks: (amplitude, cycles, period) or ('pause', seconds)"""
    out = [np.zeros(max(int(round(lead/dt)), 1))]
    for b in blocks:
        if b[0] == 'pause': out.append(np.zeros(int(round(b[1]/dt)))); continue
        A, n, T = b; t = np.arange(1, int(round(n*T/dt))+1)*dt
        ph = 2*np.pi*t/T
        out.append(A*np.sin(ph) if shape == 'sin' else A*2/np.pi*np.arcsin(np.sin(ph)))
    return np.concatenate(out)

def wander(rng, dt, T, peak, f1, f2, env=0.25):
    n = int(round(T/dt))+1; t = np.arange(n)*dt
    f = np.linspace(f1, f2, 30); x = sum(rng.normal()/fi**0.5*np.sin(2*np.pi*fi*t+rng.uniform(0, 6.28)) for fi in f)
    w = np.minimum(1, np.minimum(t/(env*T), (T-t)/(0.15*T))); x = (x-x[0])*np.clip(w, 0, 1)
    x *= peak/np.abs(x).max(); x[0] = 0
    return x

def coloured(rng, t, tau):
    dt = np.median(np.diff(t)); r = np.exp(-dt/tau); n = len(t)
    a = signal.lfilter([np.sqrt(1-r*r)], [1, -r], rng.normal(size=n+200))[200:]
    r2 = np.exp(-dt/(25*tau)); b = signal.lfilter([np.sqrt(1-r2*r2)], [1, -r2], rng.normal(size=n+2000))[2000:]
    x = 0.65*a+0.35*b+0.55*rng.normal(size=n)
    return (x-x.mean())/x.std()

def sig(x, n=4):
    s = 10.0**(np.ceil(np.log10(np.abs(x).max()+1e-300))-n)
    return np.round(x/s)*s, max(0, int(round(-np.log10(s))))

class tclrun: pass
_ns = {}
_src = open(os.environ['OPENSEES_TCL']).read()         # a program that runs Tcl through openseespy: makes t, ops, then reads sys.argv[1]
_src = _src.split('fn=sys.argv[1]')[0]
exec(compile(_src, 'opensees_tcl', 'exec'), _ns)
tcl = _ns['t']; ops = _ns['ops']
tcl.eval('proc pset {n v} {upvar #0 $n x; if {![info exists x]} {set x $v}}')
_base = set(tcl.splitlist(tcl.eval('info globals')))
def _run(text, folder, sets, params, outputs):
    for g in tcl.splitlist(tcl.eval('info globals')):
        if g not in _base and g not in ('errorInfo', 'errorCode'): tcl.eval('catch {unset ::%s}' % g)
    ops.wipe()
    cwd = os.getcwd(); d = tempfile.mkdtemp()
    for f in os.listdir(folder):
        if f.endswith('.dat'): os.symlink(os.path.abspath(os.path.join(folder, f)), os.path.join(d, f))
    os.chdir(d)
    try:
        for k, v in list(sets.items())+list(params.items()):
            tcl.setvar(k, repr(float(v)) if isinstance(v, float) else str(v))
        tcl.eval(text)
        ops.wipe()
        return {o: np.loadtxt(o) for o in outputs}
    finally:
        os.chdir(cwd); shutil.rmtree(d)
tclrun.run = staticmethod(_run)
class Case:
    noise = (0.0003, 0.0003); tau = 0.03; effects = (); context = None; sensor = None; windows = False
    confusable = []; difficulty = 'medium'; at = None; truth_model = None; spread = 0.5; starts = 3
    def nmse(s, rec, sims, roles):
        e = []
        for r in s.runs:
            if r.role not in roles: continue
            t, y = sims[r.name]
            for ch in s.channels:
                d = rec[r.name][ch[0]]; tt = rec[r.name]['t']
                e.append((r.name, ch[0], np.mean((np.interp(tt, t, y[ch[0]])-d)**2)/np.var(d)))
        return e
    def fit(s, rec, verbose=False):
        names = list(s.params); lo = np.array([s.params[k][0] for k in names], float); hi = np.array([s.params[k][1] for k in names], float)
        frs = [r for r in s.runs if r.role == 'fit']
        den = {}
        def res(q):
            p = dict(zip(names, lo+(hi-lo)*q)); out = []
            for r in frs:
                t, y = s.sim(r, p, OFF)
                for ch in s.channels:
                    d = rec[r.name][ch[0]]
                    out.append((np.interp(rec[r.name]['t'], t, y[ch[0]])-d)/np.sqrt(len(d)*np.var(d)))
            return np.concatenate(out)/np.sqrt(len(frs)*len(s.channels))
        best = None; rng = np.random.default_rng(5)
        tr = (np.array([s.params[k][3] for k in names])-lo)/(hi-lo); de = (np.array([s.params[k][2] for k in names])-lo)/(hi-lo)
        for st in ([tr, de]+[rng.uniform(0.1, 0.9, len(names)) for _ in range(5)])[:s.starts]:
            o = least_squares(res, np.clip(st, 0.001, 0.999), bounds=(0, 1), diff_step=s.diff if hasattr(s, 'diff') else 1e-3, max_nfev=25, xtol=1e-5, ftol=1e-6)
            if best is None or o.cost < best.cost: best = o
        return dict(zip(names, map(float, lo+(hi-lo)*best.x))), 2*best.cost
    def build(s, quick=False):
        t00 = time.time()
        rng = np.random.default_rng(int(hashlib.sha256(('s5'+s.name).encode()).hexdigest()[:8], 16))
        s.rng = rng; s.setup(rng)
        folder = os.path.join(ROOT, 'cases', s.name); os.makedirs(folder, exist_ok=True)
        for f in os.listdir(folder): os.remove(os.path.join(folder, f))
        open(os.path.join(folder, 'model.tcl'), 'w').write(s.tcl)
        for r in s.runs:
            for k in r.motion:
                x = r.motion[k]; dec = max(0, 5-int(np.floor(np.log10(np.abs(x).max()))))
                r.motion[k] = np.round(x, dec)
                with open(os.path.join(folder, r.name+('-'+k if k else '')+'.dat'), 'w') as f:
                    f.write('\n'.join(('%.*f' % (dec, v)) for v in r.motion[k])+'\n')
        L = ['title = "%s"' % s.title, 'model = "model.tcl"', '']
        for k, v in s.params.items(): L += ['[[parameter]]', 'name  = "%s"' % k, 'lower = %s' % repr(float(v[0])), 'upper = %s' % repr(float(v[1])), '']
        for r in s.runs:
            st = ', '.join('%s = %s' % (k, '"%s"' % v if isinstance(v, str) else repr(v)) for k, v in r.sets().items())
            L += ['[[run]]', 'name      = "%s"' % r.name, 'role      = "%s"' % r.role, 'recording = "%s.csv"' % r.name, 'set       = { %s }' % st, '']
            for ch in s.channels:
                L += ['[[run.observe]]', 'channel = "%s"' % ch[0], 'output  = "%s"' % ch[2], 'column  = %d' % ch[3], 'at      = "%s"' % ch[4], '']
        if getattr(s, 'rig', None): L += ['[rig]']+s.rig+['']
        open(os.path.join(folder, 'study.toml'), 'w').write('\n'.join(L))
        true = {k: v[3] for k, v in s.params.items()}
        # check against OpenSees with the effect off
        outs = sorted({c[2] for c in s.channels}); chk = []; times = {}
        for r in s.runs:
            t1 = time.time(); o = tclrun.run(s.tcl, folder, r.sets(), true, outs); times[r.name] = round(time.time()-t1, 2)
            t, y = s.sim(r, true, OFF)
            for c in s.channels:
                a = o[c[2]]; b = np.interp(a[:, 0], t, y[c[0]]); chk.append(np.mean((b-a[:, c[3]])**2)/np.var(a[:, c[3]]))
        # the truth
        on = {e: True for e in s.effects}; rec = {}; nf = []; clean = {}; offs = {}
        def make(on, seed):
            rg = np.random.default_rng(seed); rec = {}; nf = []
            for r in s.runs:
                t, y = s.sim(r, true, on)
                if s.sensor and 'sensor' in on: y = s.sensor(r, t, dict(y))
                n = int((t[-1]-0.02*r.rdt)/r.rdt); tt = (np.arange(n)+0.5)*r.rdt+rg.uniform(-0.12, 0.12, n)*r.rdt; tt = np.round(tt[tt < t[-1]], 5)
                d = {'t': tt}
                for c in s.channels:
                    x = np.interp(tt, t, y[c[0]]); nz = np.exp(rg.uniform(np.log(s.noise[0]), np.log(s.noise[1])))
                    e = coloured(rg, tt, s.tau)*np.sqrt(nz*np.var(x)); d[c[0]] = sig(x+e, 5)[0]
                    nf.append((r.role, c[0], r.name, np.mean((d[c[0]]-x)**2)/np.var(d[c[0]])))
                if s.context: d.update(s.context(r, tt, rg))
                rec[r.name] = d
            return rec, nf
        seed = int(rng.integers(1 << 31))
        if 'sensor' in on and not s.effects: pass
        rec, nf = make(on, seed)
        for r in s.runs:
            d = rec[r.name]; cols = [('time[s]', d['t'], 5)]
            for c in s.channels: cols.append(('%s[%s]' % (c[0], c[1]), d[c[0]], sig(d[c[0]], 5)[1]))
            for k in d:
                if '[' in k: cols.append((k, d[k], sig(d[k], 4)[1]))
            with open(os.path.join(folder, r.name+'.csv'), 'w') as f:
                f.write(','.join(c[0] for c in cols)+'\n')
                for i in range(len(d['t'])): f.write(','.join('%.*f' % (c[2], c[1][i]) for c in cols)+'\n')
        base, cost = s.fit(rec)
        sims = {}
        ver = []
        for r in s.runs:
            o = tclrun.run(s.tcl, folder, r.sets(), base, outs); y = {c[0]: o[c[2]][:, c[3]] for c in s.channels}; t = o[outs[0]][:, 0]
            t = np.concatenate([[0.0], t]); y = {k: np.concatenate([[s.start(r, k) if hasattr(s, 'start') else 0.0], v]) for k, v in y.items()}
            sims[r.name] = (t, y)
        ef = s.nmse(rec, sims, ('fit',)); eh = s.nmse(rec, sims, ('holdout',))
        F = np.mean([e[2] for e in ef]); Hh = np.mean([e[2] for e in eh])
        nff = np.mean([x[3] for x in nf if x[0] == 'fit']); nfh = np.mean([x[3] for x in nf if x[0] == 'holdout'])
        singles = {}
        if len(s.cause_list) > 1:
            for e in s.effects:
                r1, _ = make({e: True}, seed); b1, singles[e] = s.fit(r1)
                if e == s.effects[0]: ef1 = s.nmse(r1, {r.name: s.sim(r, b1, OFF) for r in s.runs}, ('fit',))
        # where
        efw = ef1 if len(s.cause_list) > 1 else ef
        big = sorted(efw, key=lambda e: -e[2]); top = big[0]
        tr = {'cause': s.cause_list[0] if s.cause_list else 'none'}
        if len(s.cause_list) > 1:
            tr['also'] = s.cause_list[1:]
            tot = sum(singles.values()); lab = dict(zip(s.effects, s.cause_list))
            tr['effect_shares'] = {lab[e]: round(singles[e]/tot, 3) for e in s.effects}
            tr['single_effect_fit_nmse'] = {lab[e]: round(float(singles[e]), 6) for e in s.effects}
        wh = {}
        if s.effects:
            acc = [e for e in efw if e[2] > getattr(s, 'thr', 0.3)*top[2]]
            if getattr(s, 'local', None): acc = [e for e in acc if e[1] in s.local] or acc
            wh = {'run': top[0], 'channel': top[1], 'accept_runs': sorted({e[0] for e in acc}, key=[r.name for r in s.runs].index),
                  'accept_channels': [c[0] for c in s.channels if c[0] in {e[1] for e in acc}]}
            if s.windows:
                r = [r for r in s.runs if r.name == top[0]][0]; t, a = s.sim(r, true, on); _, b = s.sim(r, b1 if len(s.cause_list) > 1 else base, OFF)
                dlt = np.abs(a[top[1]]-b[top[1]]); w = max(int(0.15/(t[1]-t[0])), 3)
                env = np.array(dlt); env = signal.lfilter(np.ones(w)/w, [1], dlt); act = env > 0.4*env.max(); W = []
                i = 0
                gap = s.windows if s.windows is not True else 0.6
                idx = np.flatnonzero(act)
                for i in idx:
                    if W and t[i]-W[-1][1] < gap: W[-1][1] = float(t[i])
                    else: W.append([float(t[i]), float(t[i])])
                wh['windows'] = [[round(a, 2), round(b, 2)] for a, b in W if b-a > 0.05]
            if s.at: wh['at'] = s.at
        tr.update({'where': wh, 'note': s.note, 'noise_floor_nmse_fit': round(nff, 7), 'noise_floor_nmse_holdout': round(nfh, 7),
                   'baseline_nmse_fit': round(F, 7), 'baseline_nmse_holdout': round(Hh, 7), 'baseline_parameters': {k: float('%.6g' % v) for k, v in base.items()},
                   'underlying_parameters': true, 'confusable_with': s.confusable, 'difficulty': ('easy' if F/nff > 80 else 'medium' if F/nff > 25 else 'hard') if s.effects else 'null',
                   'ratio_fit': round(F/nff, 2), 'ratio_holdout': round(Hh/nfh, 2), 'gap_scored': bool(s.effects) and tr['cause'] != 'unknown',
                   'check_nmse': float('%.3g' % max(chk)), 'channel_nmse_fit': {e[0]+'/'+e[1]: float('%.4g' % e[2]) for e in ef},
                   'opensees_run_s': times})
        json.dump(tr, open(os.path.join(ROOT, 'truth', s.name+'.json'), 'w'), indent=1)
        print('%-8s %-22s chk %.1e noise %.5f/%.5f base %.5f/%.5f ratio %.1f/%.1f lm %.5f  %ss build %.0fs' % (s.name, '+'.join(s.cause_list) or 'none', max(chk), nff, nfh, F, Hh, F/nff, Hh/nfh, cost, list(times.values()), time.time()-t00), {k: round(float(v), 5) for k, v in singles.items()})
        print('     base', {k: (float('%.4g' % v), s.params[k][3]) for k, v in base.items()}, {k: float('%.3g' % v) for k, v in tr['channel_nmse_fit'].items()}, [(r.name, {k: float('%.3g' % np.abs(v).max()) for k, v in s.sim(r, true, on)[1].items()}) for r in s.runs], sep='\n     '); sys.stdout.flush()

# ================ rigs

STATIC = '''
constraints Penalty 1.0e12 1.0e12
numberer Plain
system %s
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
'''
BWL = '''set uy [expr $Qd/((1.0-$alpha)*$ko)]
uniaxialMaterial BoucWen 1 $alpha $ko 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
'''
def rig1(head, psets, mat, ele='zero', sys='ProfileSPD', extra=''):
    if ele == 'zero':
        geo = 'model basic -ndm 1 -ndf 1\nnode 1 0.0\nnode 2 0.0\nfix 1 1\n'; el = 'element zeroLength 1 1 2 -mat 1 -dir 1\n'; col = 2
    elif ele == 'link':
        geo = 'model basic -ndm 2 -ndf 3\nnode 1 0.0 0.0\nnode 2 0.0 0.0\nfix 1 1 1 1\nfix 2 0 1 1\n'; el = 'element twoNodeLink 1 1 2 -mat 1 -dir 1 -orient 1 0 0 0 1 0\n'; col = 4
    elif ele == 'z2':
        geo = 'model basic -ndm 2 -ndf 2\nnode 1 0.0 0.0\nnode 2 0.0 0.0\nfix 1 1 1\nfix 2 0 1\n'; el = 'element zeroLength 1 1 2 -mat 1 -dir 1\n'; col = 3
    return head+'wipe\n'+geo+'\n'+psets+'\n'+mat+'\n'+el+'''
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp
'''+STATIC % sys, col

PAD2D = '''%swipe
model basic -ndm 2 -ndf 3

%s
set H %s
if {![info exists axial]} {set axial %s}
node 1 0.0 0.0
node 2 0.0 $H
fix 1 1 1 1
fix 2 0 0 1
mass 2 %s %s %s

uniaxialMaterial Elastic 1 %s
uniaxialMaterial Elastic 2 %s
%s

# vertical load first
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 [expr -$axial] 0.0
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis

# actuator
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp

constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator Newmark 0.6 0.3025
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1 $dt]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1 $dt]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
'''
def tr(r): return np.arange(r.n)*r.dt
class Rig(Case):
    starts = 7
    def sim(s, r, p, on):
        return tr(r), {'force': s.law(r, p, on)}

class Aare(Rig):
    name = 'aare'; title = 'wall panel 3, reversed cyclic loading'; cause_list = ['pinching']; effects = ('e',)
    params = {'ko': (8.0, 40.0, 15.0, 21.0), 'Qd': (30.0, 140.0, 60.0, 84.0), 'alpha': (0.02, 0.2, 0.08, 0.07)}
    noise = (0.0003, 0.0006); tau = 0.4
    note = 'slip-lock spring of Sivaselvan and Reinhorn (1999) in series with the Bouc-Wen spring: Gaussian slip stiffness around 0.25 of the strength, slip length 0.11 of the range covered so far'
    confusable = ['cyclic_degradation', 'gap_impact', 'strain_stiffening']
    def setup(s, rng):
        s.tcl, c = rig1('# Wall panel 3\n# units: kN, mm, s\n', 'pset ko    15.0\npset Qd    60.0\npset alpha 0.08\n', BWL, 'link')
        s.channels = [('force', 'kN', 'force.out', c, 'top of the panel')]
        s.runs = [R('stepped', 'fit', {'': cycles(0.05, [(6, 2, 16), (12, 2, 20), (20, 2, 24), (30, 2, 28), (12, 1, 20), (40, 1, 32)], 'tri')}, 0.05, 0.12),
                  R('record', 'holdout', {'': wander(rng, 0.05, 150, 36, 0.02, 0.12)}, 0.05, 0.12)]
    def law(s, r, p, on):
        u = r.motion['']
        return slip_lock(u, 12, p['ko'], p['Qd'], p['alpha'], 0.085, 0.22, 0.25) if on else bw(u, 12, p['ko'], p['Qd'], p['alpha'])

class Cher(Case):
    name = 'cher'; title = 'bearing LR-4 under orbits'; cause_list = []
    params = {'kInit': (4.0, 20.0, 8.0, 11.5), 'qd': (25.0, 90.0, 40.0, 56.0), 'alpha1': (0.04, 0.25, 0.1, 0.115)}
    noise = (0.0006, 0.0015); tau = 0.06
    note = 'coupled plasticity bearing exactly as modelled; coloured noise of the two load cells'
    def setup(s, rng):
        s.tcl = '''# Bearing LR-4, two-directional shear
# units: kN, mm, s
wipe
model basic -ndm 3 -ndf 6
pset kInit  8.0
pset qd     40.0
pset alpha1 0.1
node 1 0.0 0.0 0.0
node 2 0.0 0.0 180.0
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
mass 2 0.00005 0.00005 0.00005 1.0 1.0 1.0
uniaxialMaterial Elastic 1 900.0
uniaxialMaterial Elastic 2 1.0e7
uniaxialMaterial Elastic 3 1.0e7
element elastomericBearingPlasticity 1 1 2 $kInit $qd $alpha1 0.0 2.0 -P 1 -T 2 -My 3 -Mz 3 -orient 0 0 1 1 0 0

timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 0.0 [expr -$axial] 0.0 0.0 0.0
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis

timeSeries Path 2 -dt $dt -filePath $motionx
timeSeries Path 3 -dt $dt -filePath $motiony
pattern Plain 2 2 {
    sp 2 1 1.0
}
pattern Plain 3 3 {
    sp 2 2 1.0
}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 2 disp

constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-8 50
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
'''
        s.channels = [('force_x', 'kN', 'force.out', 7, 'bearing, x'), ('force_y', 'kN', 'force.out', 8, 'bearing, y')]
        dt = 0.02; t = np.arange(1801)*dt; w = 2*np.pi/6; g = np.clip(t/12, 0, 1)
        clover = {'x': 90*g*np.sin(w*t)*np.cos(w*t/2), 'y': 90*g*np.sin(w*t)*np.sin(w*t/2)}
        spiral = {'x': 100*np.clip(t/30, 0, 1)*np.sin(w*t), 'y': 70*np.clip(t/30, 0, 1)*(1-np.cos(w*t))*np.cos(w*t)}
        s.runs = [R('clover', 'fit', clover, dt, 0.024, axial=400.0), R('spiral', 'fit', spiral, dt, 0.024, axial=400.0),
                  R('mixed', 'holdout', {'x': wander(rng, dt, 36, 95, 0.1, 0.9), 'y': wander(rng, dt, 36, 80, 0.1, 0.9)}, dt, 0.024, axial=400.0)]
    def sim(s, r, p, on):
        F = j2(r.motion['x'], r.motion['y'], p['kInit'], p['qd'], p['alpha1'])
        return tr(r), {'force_x': F[:, 0], 'force_y': F[:, 1]}

class Doubs(Rig):
    name = 'doubs'; title = 'lead rubber bearing B2, repeated blocks'; cause_list = ['self_heating']; effects = ('e',)
    params = {'kInit': (6e6, 2.4e7, 1.1e7, 1.35e7), 'qd': (7e4, 2e5, 1.0e5, 1.32e5), 'alpha1': (0.04, 0.2, 0.12, 0.085)}
    noise = (0.0002, 0.0004); tau = 0.05
    note = 'lead plug heats as in Kalpakidis-Constantinou (2009), strength exp(-0.0069 T), heat leaves by radial conduction into the steel shims (finite volumes); most of the strength returns in the pause'
    confusable = ['cyclic_degradation', 'mullins_softening']
    def setup(s, rng):
        s.tcl = PAD2D % ('# Bearing B2, dynamic test\n# units: N, m, s\n', 'pset kInit  1.1e7\npset qd     1.0e5\npset alpha1 0.12\n', '0.30', '9.0e5', '200.0', '200.0', '5.0', '9.0e8', '2.0e8',
            'element elastomericBearingPlasticity 1 1 2 $kInit $qd $alpha1 0.0 2.0 -P 1 -Mz 2 -orient 0 1 0 -1 0 0')
        s.channels = [('force', 'N', 'force.out', 4, 'upper plate')]
        s.runs = [R('blocks', 'fit', {'': cycles(0.01, [(0.09, 8, 1.6), ('pause', 40), (0.09, 4, 1.6), (0.05, 3, 1.6)])}, 0.01, 0.025, axial=900000.0),
                  R('slow', 'fit', {'': cycles(0.02, [(0.05, 2, 20), (0.09, 2, 20)])}, 0.02, 0.05, axial=900000.0),
                  R('event', 'holdout', {'': wander(rng, 0.01, 40, 0.11, 0.3, 1.2, 0.12)}, 0.01, 0.025, axial=900000.0)]
    def law(s, r, p, on):
        return lrb_heat(r.motion[''], r.dt, 2, p['kInit'], p['qd'], p['alpha1'], 1.0 if on else 0.0, 0.0069, 0.068, 0.23, 0.07, 0.30)[0]

class Fulda(Rig):
    name = 'fulda'; title = 'tall pad, two loads and two speeds'; cause_list = ['axial_shear_interaction', 'rate_dependence']; effects = ('a', 'r')
    params = {'kInit': (5e5, 3e6, 1.0e6, 1.45e6), 'Fy': (4e3, 2.5e4, 9e3, 1.25e4), 'alpha': (0.1, 0.6, 0.4, 0.33)}
    noise = (0.0002, 0.0004); tau = 0.05
    note = 'Nagarajaiah-Ferrell (1999) tilting column with softening shear and rotation springs; Maxwell arm with a Ree-Eyring dashpot in parallel with the shear spring'
    confusable = ['strain_stiffening', 'damping']
    def setup(s, rng):
        s.tcl = PAD2D % ('# Tall pad under two vertical loads\n# units: N, m, s\n', 'pset kInit 1.0e6\npset Fy    9.0e3\npset alpha 0.4\n', '0.22', '1.0e5', '40.0', '40.0', '1.0', '3.0e8', '1.0e8',
            'element elastomericBearingBoucWen 1 1 2 $kInit $Fy $alpha 0.0 2.0 1.0 0.5 0.5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0')
        s.channels = [('force', 'N', 'force.out', 4, 'upper plate')]
        sh = lambda dt, T: cycles(dt, [(0.03, 2, T), (0.06, 2, T), (0.09, 2, T)])
        s.runs = [R('light-slow', 'fit', {'': sh(0.05, 25.0)}, 0.05, 0.2, axial=60000.0), R('light-fast', 'fit', {'': sh(0.005, 1.25)}, 0.005, 0.01, axial=60000.0),
                  R('heavy-slow', 'fit', {'': sh(0.05, 25.0)}, 0.05, 0.2, axial=260000.0),
                  R('heavy-mixed', 'holdout', {'': wander(rng, 0.005, 24, 0.09, 0.15, 1.6)}, 0.005, 0.0125, axial=240000.0)]
    def law(s, r, p, on):
        return tilt_eyring(r.motion[''], r.dt, r.extra['axial'], 2, p['kInit'], p['Fy'], p['alpha'], 1.0 if 'a' in on else 0.0, 1.0 if 'r' in on else 0.0,
            0.22, 1.05e6, 0.12, 1.2, 0.25, 9e5, 0.00012, 1600.0)
    def context(s, r, t, rg):
        P = r.extra['axial']; return {'axial[N]': P*(1+0.003*coloured(rg, t, 0.2))}

class Havel(Rig):
    name = 'havel'; title = 'pad V2, vertical test'; cause_list = ['cavitation']; effects = ('e',)
    params = {'kv': (150.0, 1500.0, 300.0, 420.0), 'Qv': (2.0, 40.0, 10.0, 14.0), 'alpha': (0.3, 0.95, 0.85, 0.8)}
    noise = (0.0003, 0.0005); tau = 0.3
    note = 'rubber with a population of neo-Hookean hollow spheres (growth law of the void, plateau 2.5 mu A), modulus of the void walls damaged by the largest void growth; in series with the hysteretic bearing, tension only'
    confusable = ['cyclic_degradation', 'axial_shear_interaction']
    def setup(s, rng):
        s.tcl, c = rig1('# Pad V2, vertical direction (tension positive)\n# units: kN, mm, s\n', 'pset kv    300.0\npset Qv    10.0\npset alpha 0.85\n',
            'set uy [expr $Qv/((1.0-$alpha)*$kv)]\nuniaxialMaterial BoucWen 1 $alpha $kv 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0\n', 'zero')
        s.channels = [('force', 'kN', 'force.out', c, 'upper plate')]
        def pos(dt, bl):   # blocks of (tension peak, compression peak, period)
            out = [np.zeros(1)]
            for a, b, T in bl:
                x = np.sin(2*np.pi*np.arange(1, int(T/dt)+1)*dt/T); out.append(np.where(x > 0, a*x, b*x))
            return np.concatenate(out)
        s.runs = [R('stages', 'fit', {'': pos(0.05, [(0.15, 0.6, 10)]*2+[(0.3, 0.8, 12)]*2+[(0.5, 1.0, 14)]*2+[(0.3, 0.8, 12)]+[(0.62, 1.0, 16)]*2+[(0.3, 0.8, 12)])}, 0.05, 0.1),
                  R('second', 'holdout', {'': pos(0.05, [(0.2, 0.7, 10), (0.58, 0.9, 16), (0.58, 1.0, 16), (0.2, 0.8, 10), (0.4, 0.9, 10)])}, 0.05, 0.1)]
    def law(s, r, p, on):
        return cavity(r.motion[''], 2, p['kv'], p['Qv'], p['alpha'], 1.0 if on else 0.0, 70000.0e-3, 100.0, 1.2, 0.0004, 0.5, 300.0)

class Inn(Rig):
    name = 'inn'; title = 'damper D, cyclic test'; cause_list = ['unknown']; effects = ('e',)
    params = {'E': (1e6, 6e6, 2e6, 2.9e6), 'Fy': (1.2e4, 5e4, 2e4, 2.7e4), 'b': (0.01, 0.15, 0.03, 0.055)}
    noise = (0.0002, 0.0004); tau = 0.1
    note = 'force periodic in position, two harmonics of a 23 mm pitch (cogging of a permanent-magnet linear motor); conservative, zero mean, no cause of the table'
    confusable = ['friction', 'strain_stiffening']
    def setup(s, rng):
        s.tcl, c = rig1('# Damper D\n# units: N, m, s\n', 'pset E  2.0e6\npset Fy 2.0e4\npset b  0.03\n', 'uniaxialMaterial Steel01 1 $Fy $E $b\n', 'z2')
        s.channels = [('force', 'N', 'force.out', c, 'clevis')]
        s.runs = [R('ramped', 'fit', {'': cycles(0.01, [(0.02, 2, 3), (0.045, 2, 4), (0.075, 2, 5)])}, 0.01, 0.02),
                  R('long', 'fit', {'': cycles(0.01, [(0.1, 3, 8)], 'tri')}, 0.01, 0.02), R('arbitrary', 'holdout', {'': wander(rng, 0.01, 30, 0.09, 0.1, 0.8)}, 0.01, 0.02)]
    def law(s, r, p, on):
        u = r.motion['']; F = steel01(u, p['E'], p['Fy'], p['b'])
        if on: F = F+3300.0*(np.sin(2*np.pi*u/0.023+0.4)-np.sin(0.4)+0.35*(np.sin(4*np.pi*u/0.023+1.1)-np.sin(1.1)))
        return F

class Kemi(Rig):
    name = 'kemi'; title = 'rubber pad 9, shear test'; cause_list = ['mullins_softening']; effects = ('e',); windows = 1.0
    params = {'ko': (800.0, 5000.0, 1500.0, 2100.0), 'Qd': (4e3, 3e4, 9e3, 1.25e4), 'alpha': (0.1, 0.5, 0.3, 0.24)}
    noise = (0.0002, 0.0004); tau = 0.1
    note = 'Qi-Boyce (2004) soft-domain evolution with strain amplification, acting on the elastic part and 50 % of the hysteretic part; every run starts from virgin rubber'
    confusable = ['cyclic_degradation', 'self_heating', 'strain_stiffening']
    def setup(s, rng):
        s.tcl, c = rig1('# Rubber pad 9\n# units: N, mm, s\n', 'pset ko    1500.0\npset Qd    9000.0\npset alpha 0.3\n', BWL, 'link')
        s.channels = [('force', 'N', 'force.out', c, 'upper plate')]
        s.runs = [R('stair', 'fit', {'': cycles(0.02, [(20, 3, 4), (40, 3, 4), (70, 3, 4), (100, 3, 4), (70, 2, 4), (40, 2, 4), (20, 2, 4), (100, 1, 4)])}, 0.02, 0.05),
                  R('direct', 'fit', {'': cycles(0.02, [(85, 4, 4), (30, 4, 4)])}, 0.02, 0.05),
                  R('service', 'holdout', {'': wander(rng, 0.02, 50, 95, 0.1, 0.6, 0.6)}, 0.02, 0.05)]
    def law(s, r, p, on):
        return qi_boyce(r.motion[''], 6, p['ko'], p['Qd'], p['alpha'], 62.0, 0.56, 0.84, 3.6, 4.0, 0.5) if on else bw(r.motion[''], 6, p['ko'], p['Qd'], p['alpha'])

class Neckar(Rig):
    name = 'neckar'; title = 'sliding pendulum S3'; cause_list = ['varying_axial_load']; effects = ('e',)
    params = {'kr': (100.0, 700.0, 300.0, 380.0), 'Qd': (20.0, 120.0, 40.0, 61.0), 'dy': (0.0002, 0.004, 0.001, 0.0012)}
    noise = (0.0002, 0.0004); tau = 0.04
    note = 'friction and pendulum force follow the measured vertical load N(t), friction coefficient by Tsopelas-Constantinou-Reinhorn mu_max - dmu tanh(eps p); the analyst has constant N'
    confusable = ['friction', 'axial_shear_interaction']
    def setup(s, rng):
        s.tcl = '''# Sliding pendulum S3, nominal load 950 kN
# units: kN, m, s
wipe
model basic -ndm 2 -ndf 2
pset kr 300.0
pset Qd 40.0
pset dy 0.001
node 1 0.0 0.0
node 2 0.0 0.0
fix 1 1 1
fix 2 0 1
uniaxialMaterial ElasticPP 1 [expr $Qd/$dy] $dy
uniaxialMaterial Elastic 2 $kr
element zeroLength 1 1 2 -mat 1 2 -dir 1 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp
'''+STATIC % 'BandGeneral'
        s.channels = [('force', 'kN', 'force.out', 3, 'slider')]
        dt = 0.005; t1 = np.arange(4801)*dt; f = 2*np.pi/4.0
        u1 = 0.12*np.clip(t1/4, 0, 1)*np.sin(f*t1)
        u2 = wander(rng, dt, 24, 0.14, 0.2, 1.0); u3 = wander(rng, dt, 24, 0.13, 0.2, 1.1)
        def vert(T, pk):
            a = gm('northridge_1994_arleta_360', pk, T, 2.0, dt); return signal.sosfiltfilt(signal.butter(2, [1.0, 6.0], 'band', fs=1/dt, output='sos'), a)
        v2 = vert(24, 1.0); v2 *= 0.28*950/np.abs(v2).max(); v3 = wander(rng, dt, 24, 0.26*950, 1.5, 5.0)
        s.N = {'sine': 950+1500*u1+60*np.sin(2*np.pi*1.7*t1)*np.clip(t1/4, 0, 1), 'quake-1': 950+1100*u2+v2, 'quake-2': 950+1300*u3+v3}
        s.runs = [R('sine', 'fit', {'': u1}, dt, 0.0125), R('quake-1', 'fit', {'': u2}, dt, 0.0125), R('quake-2', 'holdout', {'': u3}, dt, 0.0125)]
    def law(s, r, p, on):
        return fps(r.motion[''], s.N[r.name], 3, p['kr']/950.0, p['Qd']/p['dy'], p['Qd'], 950.0, 0.6, 0.115, 0.06, 1.0 if on else 0.0)
    def context(s, r, t, rg):
        N = np.interp(t, tr(r), s.N[r.name]); return {'axial[kN]': N+1.5*coloured(rg, t, 0.05)}

class Oder(Rig):
    name = 'oder'; title = 'yielding plate damper 2'; cause_list = ['cyclic_degradation']; effects = ('e',)
    params = {'Fy': (12.0, 50.0, 20.0, 29.0), 'E': (40.0, 200.0, 80.0, 112.0), 'b': (0.005, 0.1, 0.02, 0.033)}
    noise = (0.0003, 0.0006); tau = 0.3
    note = 'Sivaselvan-Reinhorn strength degradation: largest excursion of each sign and dissipated energy; nothing returns in the pause'
    confusable = ['self_heating', 'mullins_softening']
    def setup(s, rng):
        s.tcl, c = rig1('# Yielding plate damper 2\n# units: kip, in, s\n', 'pset Fy 20.0\npset E  80.0\npset b  0.02\n', 'uniaxialMaterial Steel01 1 $Fy $E $b\n', 'zero')
        s.channels = [('force', 'kip', 'force.out', c, 'loading beam')]
        s.runs = [R('sets', 'fit', {'': cycles(0.05, [(0.5, 3, 10), (1.0, 3, 10), (2.0, 6, 12), ('pause', 60), (2.0, 3, 12), (1.0, 3, 10)], 'tri')}, 0.05, 0.1),
                  R('near-field', 'holdout', {'': wander(rng, 0.05, 140, 2.4, 0.03, 0.2, 0.2)}, 0.05, 0.1)]
    def law(s, r, p, on):
        if not on: return steel01(r.motion[''], p['E'], p['Fy'], p['b'])
        return steel_degr(r.motion[''], 4, p['E'], p['Fy'], p['b'], 7.5, 0.7, 0.35, 1900.0)

class Saale(Rig):
    name = 'saale'; title = 'damped pad 5, three speeds'; cause_list = ['rate_dependence']; effects = ('e',)
    params = {'ko': (2e6, 1.2e7, 4e6, 5.6e6), 'Qd': (8e3, 5e4, 1.5e4, 2.0e4), 'alpha': (0.04, 0.3, 0.14, 0.12)}
    noise = (0.0002, 0.0004); tau = 0.05
    note = 'springpot (fractional derivative of order 0.22, Gruenwald-Letnikov) in parallel with the Bouc-Wen pad'
    confusable = ['damping', 'friction', 'mullins_softening']
    def setup(s, rng):
        s.tcl, c = rig1('# Damped pad 5\n# units: N, m, s\n', 'pset ko    4.0e6\npset Qd    1.5e4\npset alpha 0.14\n', BWL, 'zero')
        s.channels = [('force', 'N', 'force.out', c, 'upper plate')]
        sh = lambda dt, T: cycles(dt, [(0.015, 2, T), (0.03, 2, T), (0.045, 2, T)])
        s.runs = [R('v1', 'fit', {'': sh(0.05, 50.0)}, 0.05, 0.4), R('v2', 'fit', {'': sh(0.005, 4.0)}, 0.005, 0.03), R('v3', 'fit', {'': sh(0.0005, 0.4)}, 0.0005, 0.003),
                  R('v4', 'holdout', {'': wander(rng, 0.002, 12, 0.045, 0.4, 3.0)}, 0.002, 0.01)]
    def law(s, r, p, on):
        u = r.motion['']; F = bw(u, 10, p['ko'], p['Qd'], p['alpha'])
        if on: F = F+3.4e5*springpot(u, r.dt, 0.22)
        return F

class Ume(Rig):
    name = 'ume'; title = 'high damping bearing H6'; cause_list = ['self_heating', 'strain_stiffening']; effects = ('h', 's')
    params = {'ko': (2.0, 12.0, 4.0, 5.6), 'Qd': (25.0, 120.0, 45.0, 62.0), 'alpha': (0.04, 0.3, 0.14, 0.11)}
    noise = (0.0002, 0.0004); tau = 0.06
    note = 'Fung exponential stiffening of the elastic part; two-node heat network (core, plates) fed by the hysteretic work with Arrhenius softening of the hysteretic force (and, less, of the elastic one)'
    confusable = ['cyclic_degradation', 'mullins_softening']
    def setup(s, rng):
        s.tcl, c = rig1('# High damping bearing H6\n# units: kN, mm, s\n', 'pset ko    4.0\npset Qd    45.0\npset alpha 0.14\n', BWL, 'zero')
        s.channels = [('force', 'kN', 'force.out', c, 'upper plate')]
        s.runs = [R('staged', 'fit', {'': cycles(0.02, [(50, 2, 8), (100, 2, 8), (150, 2, 8), (200, 2, 8), (100, 2, 8)])}, 0.02, 0.05),
                  R('endurance', 'fit', {'': cycles(0.02, [(150, 14, 3), ('pause', 30), (150, 4, 3)])}, 0.02, 0.04),
                  R('arbitrary', 'holdout', {'': wander(rng, 0.02, 60, 190, 0.1, 0.6, 0.15)}, 0.02, 0.05)]
    def law(s, r, p, on):
        return fung_heat(r.motion[''], r.dt, 6, p['ko'], p['Qd'], p['alpha'], 1.0 if 's' in on else 0.0, 1.0 if 'h' in on else 0.0, 0.36, 160.0, 1500.0, 5.5e3, 1.2e4, 60.0, 250.0)[0]

# ================ structures

DYN = '''constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr %s 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
set sub 1
if {[info exists nsub]} {set sub $nsub}
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze $sub [expr $dt/double($sub)]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze $sub [expr $dt/double($sub)]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
'''
def stick_tcl(head, psets, masses, ks, cs, iso, tol='1.0e-8', ndf=1, fm='%s'):
    """iso: tcl of the isolation materials, ending with the element's -mat list"""
    n = len(masses); L = [head+'wipe']
    L.append('model basic -ndm 1 -ndf 1' if ndf == 1 else 'model basic -ndm 2 -ndf %d' % ndf)
    L.append(psets)
    fx = ['1']*ndf
    xy = (lambda i: '0.0') if ndf == 1 else (lambda i: '0.0 %g' % s_h[i])
    L.append('node 1 '+('0.0' if ndf == 1 else '0.0 0.0')); L.append('fix 1 '+' '.join(fx))
    for i, m in enumerate(masses):
        L.append('node %d %s -mass %s' % (i+2, '0.0' if ndf == 1 else '0.0 0.0', ' '.join([repr(m)]*min(ndf, 2)+['1.0']*(ndf-2))))
        if ndf > 1: L.append('fix %d 0 %s' % (i+2, ' '.join(['1']*(ndf-1))))
    L.append('\n# isolation layer'); L.append(iso)
    L.append('\n# storeys')
    for i, (k, c) in enumerate(zip(ks, cs)):
        L += ['uniaxialMaterial Elastic %d [expr $rk*%r]' % (11+i, k) if 'rk' in psets else 'uniaxialMaterial Elastic %d %r' % (11+i, k),
              'uniaxialMaterial Viscous %d %r 1.0' % (21+i, c), 'element zeroLength %d %d %d -mat %d %d -dir 1 1' % (11+i, i+2, i+3, 11+i, 21+i)]
    nd = ' '.join(str(i+2) for i in range(n))
    L.append('''
timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file basedisp.out -time -node 2 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node %s -dof 1 accel
recorder Node -file floordisp.out -time -node %s -dof 1 disp
''' % (nd, nd)+DYN % tol)
    return '\n'.join(L)
BWI = '''set ki [expr $Kd/%g]
set uy [expr $Qd/((1.0-%g)*$ki)]
uniaxialMaterial BoucWen 1 %g $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 -dir 1'''

class Stick(Case):
    ny_extra = 0; m_sub = 2; al = 0.1; cb = 0.0; mode = 0; extras = (); tau = 0.05; noise = (0.0005, 0.001)
    def chans(s, au, du, which, names=None):
        n = len(s.masses); out = []
        for w in which:
            if w == 'bd': out.append(('base_disp', du, 'basedisp.out', 1, 'isolation layer'))
            elif w == 'ba': out.append(('base_acc', au, 'acc.out', 1, 'base slab'))
            elif w == 'ra': out.append(('roof_acc', au, 'acc.out', n, 'roof'))
            elif isinstance(w, int): out.append(('floor%d_acc' % w, au, 'acc.out', w+1, 'floor %d' % w))
        return out
    def sim(s, r, p, on):
        inp, tf = r.fine(); n = len(s.masses)
        par = np.zeros(40); par[0] = n; md = s.mode if s.phys(on) else 0
        if 'Qd' in p:
            ko = p['Kd']/s.al; par[1] = ko; par[2] = p['Qd']/((1-s.al)*ko); par[3] = s.al; par[18] = s.cb
        else:
            par[1] = p['k']; par[2] = 1.0; par[3] = 1.0; par[18] = p['c']
        par[4] = md; par[5:5+n] = s.masses; rk = p.get('rk', 1.0)
        par[10:10+n-1] = np.array(s.ks)*rk; par[14:14+n-1] = s.cs
        ex = s.extras(p) if md else ()
        par[20:20+len(ex)] = ex
        ny = 2*n+1+20
        out, dout = run_stick(ny, inp, r.dt/r.sub, s.m_sub, par)
        y = {'base_disp': out[:, 0]}
        for i in range(n): y['acc%d' % i] = dout[:, n+i]+inp[:, 0]
        y['base_acc'] = y['acc0']; y['roof_acc'] = y['acc%d' % (n-1)]
        for i in range(1, n): y['floor%d_acc' % i] = y['acc%d' % i]
        return tf, y
    def phys(s, on): return any(k != 'sensor' for k in on)

class Garonne(Stick):
    name = 'garonne'; title = 'laboratory wing, three storeys'; cause_list = ['strain_stiffening']; effects = ('e',); mode = 1
    params = {'Kd': (1500.0, 5000.0, 2400.0, 2900.0), 'Qd': (120.0, 450.0, 200.0, 262.0), 'rk': (0.6, 1.5, 1.0, 1.08)}
    masses = [210.0, 170.0, 170.0, 120.0]; ks = [2.8e5, 2.4e5, 1.8e5]; cs = [650.0, 560.0, 430.0]
    noise = (0.0004, 0.0008)
    note = 'elastic part of the isolators is an eight-chain (Arruda-Boyce) rubber in simple shear with the Cohen-Pade inverse Langevin function'
    confusable = ['gap_impact', 'axial_shear_interaction']; windows = 1.0
    def extras(s, p): return (0.20, 3.2)
    def setup(s, rng):
        s.tcl = stick_tcl('# Laboratory wing, three storeys on isolators\n# units: kN, m, t, s\n', '\npset Kd 2400.0\npset Qd 200.0\npset rk 1.0     ;# storey stiffness / drawing value', s.masses, s.ks, s.cs, BWI % (0.1, 0.1, 0.1))
        s.channels = s.chans('m/s2', 'm', ['bd', 'ba', 'ra'])
        s.runs = [R('first', 'fit', {'': gm('northridge_1994_rinaldi_228', 5.2, 18)}, 0.01, 0.01, 4), R('second', 'fit', {'': gm('elcentro_1940_180', 3.4, 22)}, 0.01, 0.01, 4),
                  R('third', 'holdout', {'': gm('kobe_1995_takatori_000', 2.3, 22, 2.0)}, 0.01, 0.01, 4)]

class Jiu(Stick):
    name = 'jiu'; title = 'archive building'; cause_list = ['damping']; effects = ('e',); mode = 2
    params = {'Kd': (8.0, 40.0, 14.0, 18.5), 'Qd': (30.0, 150.0, 80.0, 62.0), 'rk': (0.5, 1.8, 1.0, 0.9)}
    masses = [1.2, 1.0, 1.0, 0.7]; ks = [620.0, 520.0, 380.0]; cs = [0.6, 0.5, 0.37]
    note = "structural damping of the storeys is Biot's (1958) nearly frequency-independent loss (ladder of five Maxwell elements, loss factor about 0.034); the analyst has only a small dashpot"
    confusable = ['rate_dependence', 'friction']
    def extras(s, p): return (2*0.034/np.pi*np.log(4.0),)+tuple(1.5*4.0**j for j in range(5))
    def setup(s, rng):
        s.tcl = stick_tcl('# Archive building\n# units: kip, in, kip s2/in, s\n', '\npset Kd 14.0\npset Qd 80.0\npset rk 1.0     ;# storey stiffness / drawing value', s.masses, s.ks, s.cs, BWI % (0.1, 0.1, 0.1), ndf=2)
        s.channels = s.chans('in/s2', 'in', ['bd', 'ba', 2, 'ra']); i = 39.37
        s.runs = [R('record-1', 'fit', {'': gm('northridge_1994_castaic_090', 3.6*i, 22, 1.0)}, 0.01, 0.01, 4),
                  R('record-2', 'holdout', {'': gm('kobe_1995_nishi_akashi_090', 4.0*i, 22, 3.0)}, 0.01, 0.01, 4)]

class Loire(Stick):
    name = 'loire'; title = 'filter house on isolators'; cause_list = ['unknown']; effects = ('e',); mode = 4
    params = {'Kd': (2500.0, 12000.0, 5000.0, 6400.0), 'Qd': (150.0, 800.0, 300.0, 410.0)}
    masses = [720.0, 150.0]; ks = [2.2e5]; cs = [900.0]
    note = 'two convective (sloshing) modes of the water, Haroun-Housner/Malhotra masses, 0.5 % damping; the analyst takes the water as rigid mass on the slab. No cause of the table'
    confusable = ['damping', 'foundation_flexibility']
    def extras(s, p): return (65.0, 2*np.pi/3.1, 0.005, 16.0, 2*np.pi/1.7, 0.005)
    def setup(s, rng):
        s.tcl = stick_tcl('# Filter house on isolators: slab, roof\n# units: kN, m, t, s\n', '\npset Kd 5000.0\npset Qd 300.0', s.masses, s.ks, s.cs, BWI % (0.1, 0.1, 0.1), ndf=3)
        s.channels = s.chans('m/s2', 'm', ['bd', 'ba', 'ra'])
        s.runs = [R('shock-a', 'fit', {'': gm('chichi_1999_tcu128_n', 1.5, 30, 16)}, 0.01, 0.012, 4), R('shock-b', 'fit', {'': gm('northridge_1994_arleta_360', 3.2, 26)}, 0.01, 0.012, 4),
                  R('shock-c', 'holdout', {'': gm('imperial_valley_1979_meloland_ff_270', 2.0, 24, 2)}, 0.01, 0.012, 4)]

class Mosel(Stick):
    name = 'mosel'; title = 'school block, three storeys'; cause_list = ['superstructure_yielding', 'sensor_lag']; effects = ('y', 'sensor'); mode = 3; noise = (0.0003, 0.0006)
    params = {'Kd': (1.2e6, 4.5e6, 2.0e6, 2.5e6), 'Qd': (1.2e5, 6e5, 2.2e5, 3.0e5), 'rk': (0.5, 1.6, 1.0, 0.93)}
    masses = [190000.0, 160000.0, 160000.0, 110000.0]; ks = [1.3e8, 1.3e8, 9.5e7]; cs = [4.5e5, 4.5e5, 3.2e5]
    note = 'first storey yields: smooth hysteresis with the pivot-rule stiffness degradation of Sivaselvan-Reinhorn (2000) and kinematic hardening; the roof accelerometer goes through a 4-pole Bessel filter of 15.5 ms group delay'
    confusable = ['damping', 'foundation_flexibility']; local = ('floor1_acc', 'floor2_acc', 'base_acc', 'roof_acc')
    def phys(s, on): return 'y' in on
    def extras(s, p): return (4.6e5, 0.12, 3.0)
    def sensor(s, r, t, y):
        b, a = signal.bessel(4, 1/0.0155, 'low', analog=True, norm='delay'); bz, az = signal.bilinear(b, a, fs=1/(t[1]-t[0]))
        y['roof_acc'] = signal.lfilter(bz, az, y['roof_acc']); return y
    def setup(s, rng):
        s.tcl = stick_tcl('# School block, three storeys on isolators\n# units: N, m, kg, s\n', '\npset Kd 2.0e6\npset Qd 2.2e5\npset rk 1.0     ;# storey stiffness / drawing value', s.masses, s.ks, s.cs, BWI % (0.08, 0.08, 0.08))
        s.channels = s.chans('m/s2', 'm', ['bd', 'ba', 1, 'ra'])
        s.runs = [R('main', 'fit', {'': gm('tabas_1978_fn', 5.2, 22, 3)}, 0.01, 0.01, 4), R('after', 'fit', {'': gm('bigbear_1992_hospitality_180', 1.3, 22, 8)}, 0.01, 0.01, 4),
                  R('other', 'holdout', {'': gm('petrolia_1992_riodell_ff_360', 6.0, 20)}, 0.01, 0.01, 4)]
    al = 0.08

class Po(Stick):
    name = 'po'; title = 'instrument platform on rubber springs'; cause_list = ['friction']; effects = ('e',); mode = 5; m_sub = 10; noise = (0.0003, 0.0006)
    params = {'k': (7e5, 3e6, 1.2e6, 1.55e6), 'c': (2e3, 2e5, 5e4, 3.0e4)}
    masses = [52000.0, 9000.0]; ks = [9.0e6]; cs = [1.5e4]
    note = 'guides rub: regularised rate-and-state friction (Dieterich-Ruina ageing law), f0 = 0.0035 of the weight'
    confusable = ['damping', 'rate_dependence']
    def extras(s, p): return (61000*9.81, 0.001, 0.0012, 0.0035, 0.01, 0.006)
    def setup(s, rng):
        s.tcl = stick_tcl('# Instrument platform on rubber springs, cabinet on top\n# units: N, m, kg, s\n', '\npset k 1.2e6\npset c 5.0e4', s.masses, s.ks, s.cs,
            'uniaxialMaterial Elastic 1 $k\nuniaxialMaterial Viscous 2 $c 1.0\nelement zeroLength 1 1 2 -mat 1 2 -dir 1 1', ndf=2)
        s.channels = s.chans('m/s2', 'm', ['bd', 'ba', 'ra']); s.channels[-1] = ('cabinet_acc', 'm/s2', 'acc.out', 2, 'cabinet')
        s.runs = [R('event-1', 'fit', {'': gm('elcentro_1940_ns_peknold', 2.8, 24)}, 0.01, 0.012, 4), R('event-2', 'fit', {'': gm('northridge_1994_arleta_360', 1.8, 24, 0)}, 0.01, 0.012, 4),
                  R('event-3', 'holdout', {'': gm('northridge_1994_canogapark_bncs_table100', 2.1, 24, 2)}, 0.01, 0.012, 4)]
    def sim(s, r, p, on):
        t, y = Stick.sim(s, r, p, on); y['cabinet_acc'] = y['roof_acc']; return t, y

class Rhone(Stick):
    name = 'rhone'; title = 'two-storey fire station'; cause_list = []; al = 0.1; noise = (0.001, 0.0022); tau = 0.08
    params = {'Kd': (5.0, 25.0, 9.0, 12.6), 'Qd': (20.0, 110.0, 60.0, 44.0), 'rk': (0.6, 1.6, 1.0, 1.17)}
    masses = [0.9, 0.75, 0.6]; ks = [480.0, 360.0]; cs = [1.4, 1.1]
    note = 'the analyst model is right; coloured sensor noise'
    def setup(s, rng):
        s.tcl = stick_tcl('# Two-storey fire station on isolators\n# units: kip, in, kip s2/in, s\n', '\npset Kd 9.0\npset Qd 60.0\npset rk 1.0     ;# storey stiffness / drawing value', s.masses, s.ks, s.cs, BWI % (0.1, 0.1, 0.1))
        s.channels = s.chans('in/s2', 'in', ['bd', 'ba', 1, 'ra']); i = 39.37
        s.runs = [R('shake-1', 'fit', {'': gm('chichi_1999_chy028_n', 4.4*i, 22, 34)}, 0.01, 0.01, 4), R('shake-2', 'holdout', {'': gm('imperial_valley_1979_meloland_ff_360', 3.0*i, 22, 2)}, 0.01, 0.01, 4)]

class Ebro(Case):
    name = 'ebro'; title = 'two-span viaduct'; cause_list = ['gap_impact']; effects = ('e',); windows = 0.5; tau = 0.05; noise = (0.0005, 0.001)
    params = {'Kd': (1500.0, 6000.0, 2400.0, 3100.0), 'Qd': (120.0, 500.0, 200.0, 265.0), 'rp': (0.5, 1.6, 1.0, 1.1)}
    note = 'the expansion joint between the two decks closes: contact by the non-linear viscoelastic model of Jankowski (2005), against a stiff rubber buffer'
    confusable = ['strain_stiffening', 'sensor_clipping']
    def setup(s, rng):
        s.tcl = '''# Two-span viaduct, longitudinal direction
# units: kN, m, t, s
wipe
model basic -ndm 1 -ndf 1
pset Kd 2400.0
pset Qd 200.0
pset rp 1.0     ;# pier stiffness / drawing value
node 1 0.0
fix 1 1
node 2 0.0 -mass 160.0
node 3 0.0 -mass 720.0
node 4 0.0 -mass 380.0
# pier
uniaxialMaterial Elastic 1 [expr $rp*90000.0]
uniaxialMaterial Viscous 2 300.0 1.0
element zeroLength 1 1 2 -mat 1 2 -dir 1 1
# bearings of the long span and of the short span (0.7 of the size)
set ki [expr $Kd/0.1]
set uy [expr $Qd/(0.9*$ki)]
uniaxialMaterial BoucWen 11 0.1 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
uniaxialMaterial BoucWen 12 0.1 [expr 0.7*$ki] 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 11 1 3 -mat 11 -dir 1
element zeroLength 12 2 3 -mat 11 -dir 1
element zeroLength 13 2 4 -mat 12 -dir 1
element zeroLength 14 1 4 -mat 12 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 3 4 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel
'''+DYN % '1.0e-8'
        s.channels = [('long_disp', 'm', 'disp.out', 2, 'long span'), ('short_disp', 'm', 'disp.out', 3, 'short span'), ('long_acc', 'm/s2', 'acc.out', 2, 'long span'), ('short_acc', 'm/s2', 'acc.out', 3, 'short span')]
        s.runs = [R('quake-1', 'fit', {'': gm('northridge_1994_castaic_090', 5.5, 20, 1)}, 0.01, 0.01, 4), R('quake-2', 'fit', {'': gm('northridge_1994_alhambra_360', 0.8, 20, 4)}, 0.01, 0.01, 4),
                  R('quake-3', 'holdout', {'': gm('tabas_1978_fn', 4.6, 20, 3)}, 0.01, 0.01, 4)]
    thr = 0.12; gap, beta, xi = 0.020, 4.0e5, 0.35
    def sim(s, r, p, on):
        inp, tf = r.fine(); ko = p['Kd']/0.1
        par = np.array([160.0, 720.0, 380.0, 90000.0*p['rp'], 300.0, ko, p['Qd']/(0.9*ko), 0.1, 0.7, 1.0 if on else 0.0, s.gap, s.beta, s.xi])
        o, d = run_spans(10, inp, r.dt/r.sub, 4, par)
        return tf, {'long_disp': o[:, 1], 'short_disp': o[:, 2], 'long_acc': d[:, 4]+inp[:, 0], 'short_acc': d[:, 5]+inp[:, 0], 'joint': o[:, 1]-o[:, 2]}

class Tagus(Case):
    name = 'tagus'; title = 'machine hall slab on four bearings'; cause_list = ['torsion']; effects = ('e',); tau = 0.05; noise = (0.0004, 0.0008)
    params = {'Kd': (300.0, 1300.0, 500.0, 640.0), 'Qd': (25.0, 120.0, 45.0, 58.0)}
    note = 'strength eccentricity (east bearings 1.11, west 0.89 of the mean strength; stiffness 1.04 and 0.96) together with a mass centre 0.20 m west and 0.14 m north of the plan centre, large-rotation-rate terms kept (de la Llera-Chopra)'
    confusable = ['bidirectional_coupling', 'sensor_gain']
    def setup(s, rng):
        L = ['''# Machine hall slab on four bearings
# units: kN, m, t, s
wipe
model basic -ndm 3 -ndf 6
pset Kd 500.0
pset Qd 45.0
node 100 0.0 0.0 0.0
mass 100 380.0 380.0 0.0 0.0 0.0 14000.0
fix 100 0 0 1 1 1 0
set ki [expr $Kd/0.1]
set uy [expr $Qd/(0.9*$ki)]
uniaxialMaterial BoucWen 1 0.1 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0''']
        for i, (x, y) in enumerate(zip((-9, 9, 9, -9), (-6, -6, 6, 6))):
            L += ['node %d %.1f %.1f 0.0' % (i+1, x, y), 'node %d %.1f %.1f 0.0' % (i+11, x, y), 'fix %d 1 1 1 1 1 1' % (i+1), 'fix %d 0 0 1 1 1 0' % (i+11),
                  'element zeroLength %d %d %d -mat 1 1 -dir 1 2' % (i+1, i+1, i+11)]
        L.append('rigidDiaphragm 3 100 11 12 13 14')
        L.append('''timeSeries Path 1 -dt $dt -filePath $motionx
timeSeries Path 2 -dt $dt -filePath $motiony
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file dispx.out -time -node 11 14 -dof 1 disp
recorder Node -file dispy.out -time -node 11 12 -dof 2 disp
recorder Node -file accx.out -timeSeries 1 -time -node 11 14 -dof 1 accel
recorder Node -file accy.out -timeSeries 2 -time -node 11 12 -dof 2 accel
'''+DYN % '1.0e-8')
        s.tcl = '\n'.join(L)
        s.channels = [('sw_x', 'm', 'dispx.out', 1, 'south-west corner, x'), ('nw_x', 'm', 'dispx.out', 2, 'north-west corner, x'), ('sw_y', 'm', 'dispy.out', 1, 'south-west corner, y'), ('se_y', 'm', 'dispy.out', 2, 'south-east corner, y'),
                      ('sw_acc_y', 'm/s2', 'accy.out', 1, 'south-west corner, y'), ('se_acc_y', 'm/s2', 'accy.out', 2, 'south-east corner, y')]
        s.runs = [R('gm-1', 'fit', {'x': gm('imperial_valley_1979_meloland_ff_360', 2.4, 22, 2), 'y': gm('imperial_valley_1979_meloland_ff_270', 1.8, 22, 2)}, 0.01, 0.0125, 3),
                  R('gm-2', 'holdout', {'x': gm('tabas_1978_fp', 3.4, 22, 3), 'y': gm('tabas_1978_fn', 3.0, 22, 3)}, 0.01, 0.0125, 3)]
    def sim(s, r, p, on):
        inp, tf = r.fine(); ko = p['Kd']/0.1
        one = np.ones(4); e = 1.0 if on else 0.0
        par = np.concatenate([[380.0, 14000.0, ko, p['Qd']/(0.9*ko), 0.1, -0.2*e, 0.14*e], one+e*0.04*np.array([-1, 1, 1, -1]), one+e*0.11*np.array([-1, 1, 1, -1]), [-9, 9, 9, -9], [-6, -6, 6, 6]])
        o, d = run_plan(14, inp, r.dt/r.sub, 6, par)
        return tf, {'sw_x': o[:, 0]+6*o[:, 2], 'nw_x': o[:, 0]-6*o[:, 2], 'sw_y': o[:, 1]-9*o[:, 2], 'se_y': o[:, 1]+9*o[:, 2],
                    'sw_acc_y': d[:, 4]-9*d[:, 5]+inp[:, 1], 'se_acc_y': d[:, 4]+9*d[:, 5]+inp[:, 1]}

class Brahe(Case):
    name = 'brahe'; title = 'river bridge, pier with isolated deck'; cause_list = ['foundation_flexibility']; effects = ('e',); tau = 0.05; noise = (0.0006, 0.0012)
    params = {'Kd': (1.5e6, 6e6, 2.6e6, 3.3e6), 'Qd': (1.5e5, 8e5, 3e5, 4.2e5), 'rE': (0.5, 1.6, 1.0, 1.12)}
    note = "Wolf's cone models below the pier: sway spring and dashpot, rocking spring with the monkey-tail internal rotation (mass and dashpot), trapped-soil inertia; the analyst has a fixed base"
    confusable = ['superstructure_yielding', 'damping']; at = 'pier'; starts = 2; diff = 5e-3
    def setup(s, rng):
        s.tcl = '''# River bridge, pier with isolated deck
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 3
pset Kd 2.6e6
pset Qd 3.0e5
pset rE 1.0     ;# pier flexural rigidity / drawing value
node 1 0.0 0.0
node 2 0.0 5.5
node 3 0.0 11.0
node 4 0.0 11.0
# base
fix 1 1 1 1
fix 4 0 1 1
mass 2 60000.0 60000.0 4000.0
mass 3 110000.0 110000.0 6000.0
mass 4 520000.0 520000.0 1.0
geomTransf Linear 1
element elasticBeamColumn 1 1 2 2.8 [expr $rE*3.1e10] 0.62 1
element elasticBeamColumn 2 2 3 2.8 [expr $rE*3.1e10] 0.62 1
rayleigh 0.6 0.0 0.003 0.0
set ki [expr $Kd/0.08]
set uy [expr $Qd/(0.92*$ki)]
uniaxialMaterial BoucWen 1 0.08 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 20 3 4 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 3 4 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel
recorder Element -file bearing.out -time -ele 20 deformation
'''+DYN % '1.0e-8'
        s.channels = [('mid_disp', 'm', 'disp.out', 1, 'pier, mid-height'), ('cap_disp', 'm', 'disp.out', 2, 'pier cap'), ('mid_acc', 'm/s2', 'acc.out', 1, 'pier, mid-height'), ('cap_acc', 'm/s2', 'acc.out', 2, 'pier cap'),
                      ('bearing_def', 'm', 'bearing.out', 1, 'bearing')]
        rho, vs, nu, r0 = 1900.0, 250.0, 1/3, 2.8
        A = np.pi*r0**2; I = np.pi*r0**4/4; vp = 2*vs
        Kh = 8*rho*vs**2*r0/(2-nu); Ch = rho*vs*A; Kt = 8*rho*vs**2*r0**3/(3*(1-nu)); Ct = rho*vp*I
        z0 = r0*9*np.pi/32*(1-nu)*(vp/vs)**2; Mt = rho*I*z0
        hid = '''fix 1 0 1 0
node 90 0.0 0.0
node 91 0.0 0.0
fix 90 1 1 1
fix 91 1 1 0
mass 1 70000.0 70000.0 160000.0
mass 91 1.0 1.0 %r
uniaxialMaterial Elastic 90 %r
uniaxialMaterial Viscous 91 %r 1.0
uniaxialMaterial Elastic 92 %r
uniaxialMaterial Viscous 93 %r 1.0
element zeroLength 90 90 1 -mat 90 91 92 -dir 1 1 6
element zeroLength 91 91 1 -mat 93 -dir 6
''' % (Mt, Kh, Ch, Kt, Ct)
        s.hid = s.tcl.replace('fix 1 1 1 1\n', hid)
        s.runs = [R('event-a', 'fit', {'': gm('northridge_1994_castaic_090', 3.4, 18, 1)}, 0.01, 0.01, 3), R('event-b', 'holdout', {'': gm('petrolia_1992_riodell_ff_360', 3.8, 18)}, 0.01, 0.01, 3)]
    def sim(s, r, p, on):
        o = tclrun.run(s.hid if on else s.tcl, os.path.join(ROOT, 'cases', s.name), r.sets(), p, ['disp.out', 'acc.out', 'bearing.out'])
        t = np.concatenate([[0], o['disp.out'][:, 0]]); return t, {c[0]: np.concatenate([[0], o[c[2]][:, c[3]]]) for c in s.channels}

def every(c):
    for d in c.__subclasses__():
        yield d; yield from every(d)
if __name__ == '__main__':
    for C in sorted((c for c in every(Case) if hasattr(c, 'name')), key=lambda c: c.name):
        if len(sys.argv) == 1 or C.name in sys.argv[1:]: C().build()
