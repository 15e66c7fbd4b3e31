"""Prints a package's public names with signatures and docstrings as Markdown: python python_reference.py FOLDER"""

import ast
import re
import sys
from pathlib import Path


def markdown(doc: str | None) -> str:
    """Converts reStructuredText roles and literals in a docstring to Markdown."""
    plain = re.sub(r":\w+:`~?([^`]+)`", r"`\1`", doc or "")
    return plain.replace("``", "`")


def signature(function: ast.FunctionDef, name: str) -> str:
    returns = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    own = ast.unparse(function.args).removeprefix("self, ").removeprefix("self")
    return f"```python\n{name}({own}){returns}\n```"


def decorators(function: ast.FunctionDef) -> set[str]:
    return {ast.unparse(each) for each in function.decorator_list}


def of_method(owner: str, method: ast.FunctionDef) -> str:
    is_attribute = "property" in decorators(method)
    head = f"`{method.name}`: `{ast.unparse(method.returns)}`" if is_attribute else signature(method, method.name)
    return f"### {owner}.{method.name}\n\n{head}\n\n{markdown(ast.get_docstring(method))}"


def fields(each: ast.ClassDef) -> str:
    lines = [ast.unparse(field) for field in each.body if isinstance(field, ast.AnnAssign)]
    return "```python\n" + "\n".join(lines) + "\n```\n\n" if lines else ""


def of_class(each: ast.ClassDef) -> str:
    methods = [method for method in each.body if isinstance(method, ast.FunctionDef)]
    constructor = [signature(method, each.name) for method in methods if method.name == "__init__"]
    documented = [method for method in methods if not method.name.startswith("_") and ast.get_docstring(method)]
    public = [of_method(each.name, method) for method in documented]
    parts = [f"## rosto.{each.name}", *constructor, fields(each) + markdown(ast.get_docstring(each)), *public]
    return "\n\n".join(parts)


def of_name(name: str, found: dict[str, ast.stmt]) -> str:
    each = found[name]
    if isinstance(each, ast.ClassDef):
        return of_class(each)
    if isinstance(each, ast.FunctionDef):
        return f"## rosto.{name}\n\n{signature(each, f'rosto.{name}')}\n\n{markdown(ast.get_docstring(each))}"
    return f"## rosto.{name}\n\n```python\n{ast.unparse(each)}\n```"


def main(folder: Path) -> None:
    package = ast.parse((folder / "__init__.py").read_text())
    modules = [ast.parse(file.read_text()) for file in sorted(folder.glob("_*.py*"))]
    found: dict[str, ast.stmt] = {}
    for node in (node for module in modules for node in module.body):
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            found.setdefault(node.name, node)
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            found.setdefault(node.targets[0].id, node)
    names = ast.literal_eval(next(node.value for node in package.body if isinstance(node, ast.Assign)))
    order = sorted(names, key=lambda name: (not isinstance(found[name], ast.FunctionDef), name))
    print(f"# Python reference\n\n{markdown(ast.get_docstring(package))}\n")
    print("\n\n".join(of_name(name, found) for name in order))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
