"""Saliency of rendered pictures, and whether it lies in the focus: models, measures, paired
statistics, verdict. See README.md.
"""
from .experiment import CONDITIONS, Observation, analyse
from .fixations import fixations, map_fixations
from .itti import saliency_maps
from .metrics import detail, moved_masks, scores, shuffled_nss
from .models import MODELS, PRIMARY, SECOND_OPINION, SINGLE_PASS, examine
from .pictures import draw_fixations, heat_map, read_picture, write_picture
from .spectral_residual import spectral_residual
from .verdict import judge
