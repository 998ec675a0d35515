"""One bearing under some ground motions, and all that is said of it: what the report and the page show."""

from dcfp.study.scenario.calculation import Calculation as Calculation
from dcfp.study.scenario.calculation import Result as Result
from dcfp.study.scenario.calculation import calculate as calculate
from dcfp.study.scenario.read import read_scenario as read_scenario
from dcfp.study.scenario.scenario import Heading as Heading
from dcfp.study.scenario.scenario import Scenario as Scenario
from dcfp.study.scenario.write import scenario_toml as scenario_toml
