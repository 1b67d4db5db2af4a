"""which case carries which river (shuffled)"""
import random
N = ['quiet_damper', 'quiet_pad', 'quiet_house', 'fixture', 'tank', 'tilt', 'fan', 'wall_degrade', 'pendulum_axial', 'tension', 'panel_pinch', 'lead_heat',
     'fractional', 'iso_stiff', 'extra_damp', 'gain', 'clip', 'abut', 'rub', 'pier_soil', 'virgin_late', 'stiff_fast', 'yield_gain', 'plan']
R = 'avon cam dee esk forth gwash humber isis kennet lune medway nene ouse piddle quarme ribble severn tamar trent tyne usk welland wye yare'.split()
random.Random(730114).shuffle(N)
RIVER = dict(zip(N, R))
