"""One bearing under some ground motions, and all that is said of it: what the report and the page show."""

from dcfp.scenario.calculation import Calculation as Calculation
from dcfp.scenario.calculation import Result as Result
from dcfp.scenario.calculation import calculate as calculate
from dcfp.scenario.read import read_scenario as read_scenario
from dcfp.scenario.scenario import Heading as Heading
from dcfp.scenario.scenario import Scenario as Scenario
from dcfp.scenario.write import scenario_toml as scenario_toml
