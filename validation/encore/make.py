"""generates the cases and their sealed truth:  python make.py [working names]
Environment: OPENSEES_TCL (the runner of Tcl scripts), GROUND_MOTIONS (folder of the recorded motions)."""
import sys, os, json, time, hashlib
import lib, cases_rig
ALL = dict(cases_rig.ALL)
try:
    import cases_bld
    ALL.update(cases_bld.ALL)
    import cases_plan
    ALL.update(cases_plan.ALL)
except ImportError:
    pass
try:
    from river import RIVER
except ImportError:
    RIVER = {}
if __name__ == '__main__':
    todo = sys.argv[1:] or list(ALL)
    for k in todo:
        t0 = time.time()
        name = RIVER.get(k, 'tmp_' + k)
        try:
            truth, rep = lib.process(ALL[k](), name, int(hashlib.sha256(k.encode()).hexdigest()[:8], 16), f'{lib.HERE}/cases/{name}')
        except Exception as e:
            import traceback
            traceback.print_exc()
            print(k, 'FAILED', e, flush=True)
            continue
        os.makedirs(f'{lib.HERE}/truth', exist_ok=True)
        json.dump(truth, open(f'{lib.HERE}/truth/{name}.json', 'w'), indent=1)
        print(f"{k:15s} {truth['cause']:22s} ratio {truth['ratio_fit']}/{truth['ratio_holdout']} base {truth['baseline_nmse_fit']:.4f} floor {truth['noise_floor_nmse_fit']:.5f} "
              f"chk {truth.get('self_check_effect_off_nmse')}/{truth.get('self_check_worst_channel')} {truth.get('effect_shares', '')} {time.time() - t0:.0f}s\n    "
              f"{truth['baseline_parameters']} {truth['underlying_parameters']}\n    {rep} {truth['where']}", flush=True)
