"""Results as NetCDF groups and as lines of text, with units."""

from dcfp.present.tables.columns import Column as Column
from dcfp.present.tables.columns import table_text as table_text
from dcfp.present.tables.motions import MEASURES as MEASURES
from dcfp.present.tables.motions import motion_csv as motion_csv
from dcfp.present.tables.motions import motion_dataset as motion_dataset
from dcfp.present.tables.motions import motion_names as motion_names
from dcfp.present.tables.motions import write_motions_netcdf as write_motions_netcdf
from dcfp.present.tables.responses import COLUMNS as COLUMNS
from dcfp.present.tables.responses import csv_text as csv_text
from dcfp.present.tables.responses import cycles_csv as cycles_csv
from dcfp.present.tables.responses import group_names as group_names
from dcfp.present.tables.responses import summary_dataset as summary_dataset
from dcfp.present.tables.responses import write_netcdf as write_netcdf
from dcfp.present.tables.responses import write_tests_netcdf as write_tests_netcdf
