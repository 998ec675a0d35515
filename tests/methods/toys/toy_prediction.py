"""A method of prediction from outside of the package: y_max is a fifth of a second times the PGV."""

from dcfp.methods import Prediction
from dcfp.methods.method import Information, Look
from dcfp.methods.prediction import Ground, Methods, Predicted, PredictionMethod
from dcfp.schema.formulas import Formula, number

NAME = "toy prediction"
SECONDS = 0.2


def predict(ground: Ground, methods: Methods) -> Predicted:
    found = SECONDS * ground.pgv
    return Predicted(Prediction(found, ground.pgv, ground.pgv, found), remarks=("The toy was asked.",))


def formulas(ground: Ground, methods: Methods) -> tuple[Formula, ...]:
    found = SECONDS * ground.pgv
    numbers = f"{SECONDS:g} times {number(ground.pgv, 1)}"
    return (Formula("Toy displacement of the prediction", 'y_"max" = 0.2 "PGV"', numbers, found, 1, "mm", "toy, 2.1"),)  # fmt: skip


TOY_PREDICTION = PredictionMethod(
    key="toy-prediction",
    name=NAME,
    head="toy",
    knows=(Information.BLIND,),
    citations=("li_2020",),
    look=Look("d", "#882255"),
    predict=predict,
    formulas=formulas,
)
