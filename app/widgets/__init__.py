"""Controls that know nothing of a document: sliders, number fields with units, labels, lists.

They speak in signals and values.
"""
